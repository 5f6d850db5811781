-- tries to change what objects are
-- expect: error
getmetatable(object).__index = nil
