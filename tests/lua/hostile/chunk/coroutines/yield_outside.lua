-- tries to yield where nobody resumes
-- expect: error
coroutine.yield()
