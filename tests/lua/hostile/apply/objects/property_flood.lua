-- tries to be refused for ever, with suggestions
-- expect: limit
while true do pcall(function() return object.Velocty end) end
