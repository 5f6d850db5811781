-- tries to compile more code
-- expect: error
return load('return 1')()
