-- tries to name parameters by what is no name
-- expect: refused
return interaction { name = 'Dynamics <- Hostile', calls = 'Dynamics', each = { 'Mass' },
  params = { ['a b'] = { default = 1 }, ['1'] = { default = 0 / 0 } }, apply = function() end }
