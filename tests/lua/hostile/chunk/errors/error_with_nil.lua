-- tries to fail without a message
-- expect: error
error(nil)
