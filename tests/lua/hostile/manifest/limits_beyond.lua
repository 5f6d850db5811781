-- tries to ask for more than anybody may have
-- expect: refused
return interaction { name = 'Dynamics <- Hostile', calls = 'Dynamics', each = { 'Mass' },
  limits = { instructions = 1e12 }, apply = function() end }
