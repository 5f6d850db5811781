-- tries to confuse the counting of blocks by strings that look like code
-- expect: limit
local s = 'end end end'
local t = [[ while true do ]]
while #s > 0 do local u = "until" end
