-- tries to run code when memory is collected
-- expect: error
newproxy(true)
