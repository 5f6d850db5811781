-- tries to be a table that contains itself
-- expect: refused
local t = { name = 'Dynamics <- Hostile', calls = 'Dynamics', each = { 'Mass' }, apply = function() end }
t.params = t
return t
