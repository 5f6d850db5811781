-- tries to write a property through the vector that it was given
-- expect: harmless
object.Velocity.value.x = 1e9
