-- tries to write a property
-- expect: error
object.Velocity.value = vec2(0, 0)
