-- tries to read what it does not declare
-- expect: error
local x = object.Rotation
