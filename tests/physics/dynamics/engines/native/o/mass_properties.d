o/mass_properties.o: \
 ../../../../../physics/dynamics/properties/shapes/mass_properties.cpp \
 ../../../../../physics/dynamics/properties/shapes/mass_properties.hpp \
 ../../../../../physics/dynamics/properties/body.hpp \
 ../../../../../runtime/property/description.hpp \
 ../../../../../runtime/level/json/limits.hpp \
 ../../../../../runtime/math/vec2.hpp \
 ../../../../../runtime/object/object_id.hpp \
 ../../../../../physics/dynamics/properties/shape.hpp \
 ../../../../../physics/depth.hpp \
 ../../../../../physics/dynamics/properties/shapes/shape_order.hpp
