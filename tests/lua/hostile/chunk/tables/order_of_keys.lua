-- tries to get an order that differs from run to run
-- expect: harmless
local s = ''
for k in pairs({ b = 1, a = 2, [2] = 3, [1] = 4, c = 5 }) do s = s .. k end
assert(s == '12abc')
assert(next({ z = 1, y = 2 }) == 'y')
