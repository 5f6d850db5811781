o/substep_motion.o: \
 ../../../../../physics/dynamics/engines/box2d/substep_motion.cpp \
 ../../../../../physics/dynamics/engines/box2d/substep_motion.hpp
