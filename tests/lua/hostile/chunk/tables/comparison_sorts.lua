-- tries to loop in what the host calls for it
-- expect: limit
local function slow() for i = 1, 1e9 do end return true end
table.sort({ 1, 2, 3, 4 }, slow)
