-- tries to see how much memory is in use
-- expect: error
return gcinfo()
