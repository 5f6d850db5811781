-- tries to read a file
-- expect: error
return io.open('/etc/passwd')
