-- tries to run a program
-- expect: error
os.execute('true')
