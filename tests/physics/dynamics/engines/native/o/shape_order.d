o/shape_order.o: \
 ../../../../../physics/dynamics/properties/shapes/shape_order.cpp \
 ../../../../../physics/dynamics/properties/shapes/shape_order.hpp \
 ../../../../../physics/dynamics/properties/shape.hpp \
 ../../../../../runtime/property/description.hpp \
 ../../../../../runtime/level/json/limits.hpp \
 ../../../../../runtime/math/vec2.hpp \
 ../../../../../runtime/object/object_id.hpp
