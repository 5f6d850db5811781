-- tries to loop in the handler of errors
-- expect: limit
xpcall(function() while true do end end, function() while true do end end)
while true do end
