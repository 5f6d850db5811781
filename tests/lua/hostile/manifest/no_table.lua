-- tries to be no description
-- expect: refused
return function() end
