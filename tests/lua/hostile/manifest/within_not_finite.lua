-- tries to be applied to pairs at no finite distance
-- expect: refused
return interaction { name = 'Dynamics <- Hostile', calls = 'Dynamics',
  pairs = { first = { 'Mass' }, second = { 'Mass' }, within = 1 / 0 }, apply = function() end }
