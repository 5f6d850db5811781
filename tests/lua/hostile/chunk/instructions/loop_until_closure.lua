-- tries to loop in the condition of until
-- expect: limit
repeat until (function() for i = 1, 10 do end return false end)()
