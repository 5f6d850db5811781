-- tries to get at compiled code
-- expect: error
return string.dump(function() end)
