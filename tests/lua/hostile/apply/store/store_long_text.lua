-- tries to keep a long text
-- expect: error
store.script.text = ('x'):rep(101)
