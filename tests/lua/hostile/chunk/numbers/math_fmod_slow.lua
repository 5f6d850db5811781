-- tries to divide with remainder what takes 2000 steps
-- expect: limit
while true do math.fmod(1.7e308, 3.3) end
