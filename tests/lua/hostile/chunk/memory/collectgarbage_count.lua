-- tries to see how much memory is used, which differs from run to run
-- expect: error
return collectgarbage('count')
