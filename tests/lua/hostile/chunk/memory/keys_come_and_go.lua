-- tries to have LuaJIT make a full table anew at every instruction
-- expect: limit
local t = {}
for i = 1, 128 do t[i + 0.5] = 1 end
local a = 1
while true do
  t[a + 0.5] = nil
  t[a + 128.5] = 1
  a = a + 1
end
