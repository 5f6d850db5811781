o/engine_failure.o: \
 ../../../../../physics/dynamics/core/engine_failure.cpp \
 ../../../../../physics/dynamics/core/engine_failure.hpp
