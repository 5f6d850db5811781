-- tries to hide such a text behind escapes
-- expect: refused
local s = '\49\101\51\48\56'
while true do local x = s + 0 end
