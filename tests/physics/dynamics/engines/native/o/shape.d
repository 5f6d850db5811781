o/shape.o: ../../../../../physics/dynamics/properties/shape.cpp \
 ../../../../../physics/dynamics/properties/shape.hpp \
 ../../../../../runtime/property/description.hpp \
 ../../../../../runtime/level/json/limits.hpp \
 ../../../../../runtime/math/vec2.hpp \
 ../../../../../runtime/object/object_id.hpp \
 ../../../../../physics/dynamics/properties/shapes/shape_order.hpp
