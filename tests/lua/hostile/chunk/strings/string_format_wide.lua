-- tries to ask for a huge width
-- expect: error
string.format('%999999999d', 1)
