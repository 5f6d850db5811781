-- tries to leave apply by a yield
-- expect: error
coroutine.yield(object)
