-- tries to be looked through for ever: tables that are a thousand times in others
-- expect: refused
local t = {}
for depth = 1, 5 do
  local next_ = {}
  for i = 1, 300 do next_[i] = t end
  t = next_
end
return interaction { name = 'Dynamics <- Hostile', calls = 'Dynamics', each = { 'Mass' }, reads = t,
  apply = function() end }
