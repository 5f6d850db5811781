local next_ = coroutine.wrap(function() for i = 1, 3 do coroutine.yield(i) end end)
while true do local i = next_() if not i then break end log(i) end
