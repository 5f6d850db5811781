o/impacts.o: ../../../../../physics/dynamics/properties/impacts.cpp \
 ../../../../../physics/dynamics/properties/impacts.hpp \
 ../../../../../runtime/math/vec2.hpp \
 ../../../../../runtime/property/coverage.hpp \
 ../../../../../runtime/property/description.hpp \
 ../../../../../runtime/level/json/limits.hpp \
 ../../../../../runtime/object/object_id.hpp \
 ../../../../../runtime/property/news.hpp
