o/box2d_crowd.o: \
 ../../../../../physics/dynamics/engines/box2d/box2d_crowd.cpp \
 ../../../../../physics/dynamics/engines/box2d/box2d_crowd.hpp
