local s = ("ab"):rep(3) .. 1 .. tostring(vec2(1, 2))
log(s:upper():sub(2, -2), ("%5.2f %s"):format(1.5, "x"), s:find("b"))
return #s
