-- tries to keep a table
-- expect: error
store.script.count = {}
