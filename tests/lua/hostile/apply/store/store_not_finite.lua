-- tries to keep what is no number
-- expect: error
store.script.count = 0 / 0
