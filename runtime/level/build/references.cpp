#include "runtime/level/build/references.hpp"

#include "runtime/level/json/json_locator.hpp"
#include "runtime/property/idle_visitor.hpp"

namespace trembler {
namespace {

class ReferenceResolver final : public IdleVisitor {
public:
    ReferenceResolver(NameTable const& names, Store const& store, std::string const& prefix)
        : names_(names), store_(store), prefix_(prefix) {}

    std::vector<DanglingReference> dangling;

    void object(FieldInfo const& info, ObjectId& id) override {
        if (!id.valid()) {
            return;
        }
        std::string const name = names_.nameOf(id);
        id = store_.find(prefix_ + name);
        if (!id.valid()) {
            dangling.push_back({pathOf(info), name});
        }
    }
    void list(FieldInfo const& info, ListField& field) override {
        std::string const outer = path_;
        std::string const here = pathOf(info);
        for (std::size_t i = 0; i < field.size(); ++i) {
            path_ = pointerTo(here, i);
            field.visitElement(i, *this);
        }
        path_ = outer;
    }

private:
    [[nodiscard]] std::string pathOf(FieldInfo const& info) const {
        return info.key == "value" ? path_ : pointerTo(path_, info.key);
    }

    NameTable const& names_;
    Store const& store_;
    std::string const& prefix_;
    std::string path_;
};

} // namespace

std::vector<DanglingReference> resolveReferences(PropertyValue& value, NameTable const& names,
                                                 Store const& store, std::string const& prefix) {
    ReferenceResolver resolver(names, store, prefix);
    value.visit(resolver);
    return std::move(resolver.dangling);
}

} // namespace trembler
