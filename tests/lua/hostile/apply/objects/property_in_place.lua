-- tries to write a property through the vector that it was given
-- expect: error
object.Velocity.value.x = 1e9
