-- tries to catch the limit with a wrapped coroutine in a pcall
-- expect: limit
while true do
  pcall(coroutine.wrap(function() while true do end end))
end
