o/drag.o: ../../../../../physics/dynamics/core/drag.cpp \
 ../../../../../physics/dynamics/core/drag.hpp \
 ../../../../../runtime/math/vec2.hpp
