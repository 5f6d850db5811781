-- tries to print an address, which differs from run to run
-- expect: error
return string.format('%p', {})
