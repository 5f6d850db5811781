-- tries to go round a read-only table
-- expect: error
rawset(math, 'pi', 3)
