-- tries to run compiled code
-- expect: error
return loadstring('\27LJ')
