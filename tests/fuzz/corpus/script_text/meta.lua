local class = {}
class.__index = class
class.__add = function(a, b) return 1 end
local o = setmetatable({}, class)
function class:f() return self + self end
return o:f(), pcall(o.g)
