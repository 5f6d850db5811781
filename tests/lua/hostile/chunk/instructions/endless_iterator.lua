-- tries to iterate without end
-- expect: limit
for x in function() return 1 end do end
