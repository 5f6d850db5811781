#include "physics/electricity/analyses/blocks.hpp"

#include <boost/graph/biconnected_components.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>

namespace trembler {

std::vector<std::size_t> blocksOf(std::vector<BlockEdge> const& edges, std::size_t vertices) {
    // Every connection is two directed edges of a compressed graph. For the algorithm this equals an
    // undirected graph, which lists its edges at both ends, too; building it is an order of magnitude
    // cheaper.
    using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                     boost::no_property, std::uint32_t, std::uint32_t>;
    Graph const graph(boost::edges_are_sorted, edges.begin(), edges.end(),
                      static_cast<std::uint32_t>(vertices));
    std::vector<std::size_t> blocks(edges.size(), noBlock);
    boost::biconnected_components(
        graph, boost::make_iterator_property_map(blocks.begin(), boost::get(boost::edge_index, graph)));
    return blocks;
}

} // namespace trembler
