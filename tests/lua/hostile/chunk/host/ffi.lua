-- tries to reach the memory of the process
-- expect: error
return require('ffi')
