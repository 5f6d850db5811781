-- tries to have a name that does not say what it calls
-- expect: refused
return interaction { name = 'Population <- Dynamics', calls = 'Dynamics', each = { 'Mass' }, apply = function() end }
