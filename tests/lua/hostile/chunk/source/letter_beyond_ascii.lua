-- tries to name what stands between the operands of ..
-- expect: refused
local ‥ = 1
