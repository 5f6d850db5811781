-- tries to join what is no text
-- expect: error
return 'x' .. {}
