-- tries to change all vectors
-- expect: error
getmetatable(vec2(1, 2)).__add = nil
