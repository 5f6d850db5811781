-- tries to have a name of many bytes
-- expect: refused
return interaction { name = 'Dynamics <- ' .. ('x'):rep(900), calls = 'Dynamics', each = { 'Mass' }, apply = function() end }
