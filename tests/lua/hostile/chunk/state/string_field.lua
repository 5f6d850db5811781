-- tries to keep a state in a string
-- expect: error
('').mine = 1
