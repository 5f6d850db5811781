-- tries to catch the end of memory and go on
-- expect: limit
while true do
  pcall(function()
    local t = {}
    while true do t[#t + 1] = { 1, 2, 3 } end
  end)
end
