-- tries to get at what stands between the operands of .., by a metamethod that is set later
-- expect: error
local meta, got = {}, nil
local t = setmetatable({}, meta)
meta.__concat = function(a, b) got = b return 'joined' end
local s = t .. 'x'
got.kept = 1
