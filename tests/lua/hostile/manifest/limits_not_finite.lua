-- tries to ask for a limit that is none
-- expect: refused
return interaction { name = 'Dynamics <- Hostile', calls = 'Dynamics', each = { 'Mass' },
  limits = { calls = 0 / 0 }, apply = function() end }
