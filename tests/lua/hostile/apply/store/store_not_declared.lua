-- tries to keep what it has not declared
-- expect: error
store.script.more = 1
