-- tries to catch the limit and go on
-- expect: limit
while true do pcall(function() while true do end end) end
