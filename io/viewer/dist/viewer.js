"use strict";(()=>{var dg="uplot",pg="u-hz",mg="u-vt",gg="u-title",_g="u-wrap",xg="u-under",vg="u-over",yg="u-axis",Rs="u-off",Mg="u-select",bg="u-cursor-x",Sg="u-cursor-y",wg="u-cursor-pt",Tg="u-legend",Eg="u-live",Ag="u-inline",Cg="u-series",Rg="u-marker",ef="u-label",Pg="u-value",oo="width",ao="height";var tf="bottom",ur="left",Tc="right",Hc="#000",nf=Hc+"0",Ec="mousemove",sf="mousedown",Ac="mouseup",rf="mouseenter",of="mouseleave",af="dblclick",Ig="resize",Lg="scroll",lf="change",ca="dppxchange",Gc="--",xr=typeof window<"u",Lc=xr?document:null,dr=xr?window:null,Dg=xr?navigator:null,vt,ra;function Dc(){let i=devicePixelRatio;vt!=i&&(vt=i,ra&&Fc(lf,ra,Dc),ra=matchMedia(`(min-resolution: ${vt-.001}dppx) and (max-resolution: ${vt+.001}dppx)`),Ps(lf,ra,Dc),dr.dispatchEvent(new CustomEvent(ca)))}function Vn(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Uc(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Ot(i,e,t){i.style[e]=t+"px"}function ai(i,e,t,n){let s=Lc.createElement(i);return e!=null&&Vn(s,e),t?.insertBefore(s,n),s}function Qn(i,e){return ai("div",i,e)}var cf=new WeakMap;function vi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=cf.get(i);r!=o&&(i.style.transform=r,cf.set(i,r),e<0||t<0||e>n||t>s?Vn(i,Rs):Uc(i,Rs))}var hf=new WeakMap;function uf(i,e,t){let n=e+t,s=hf.get(i);n!=s&&(hf.set(i,n),i.style.background=e,i.style.borderColor=t)}var ff=new WeakMap;function df(i,e,t,n){let s=e+""+t,r=ff.get(i);s!=r&&(ff.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Wc={passive:!0},Ug={...Wc,capture:!0};function Ps(i,e,t,n){e.addEventListener(i,t,n?Ug:Wc)}function Fc(i,e,t,n){e.removeEventListener(i,t,Wc)}xr&&Dc();function li(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:Hn((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Vf(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var Hf=i=>i!=null,Gf=i=>i!=null&&i>0,fa=Vf(Hf),Fg=Vf(Gf);function Ng(i,e,t,n=0,s=!1){let r=s?Fg:fa,o=s?Gf:Hf;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Pt,l??-Pt]}function da(i,e,t,n){let s=gf(i),r=gf(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?Fi:Wf,a=s==1?Hn:ei,l=r==1?ei:Hn,c=a(o(rn(i))),u=l(o(rn(e))),h=pr(t,c),f=pr(t,u);return t==10&&(c<0&&(h=It(h,-c)),u<0&&(f=It(f,-u))),n||t==2?(i=h*s,e=f*r):(i=$f(i,h),e=pa(e,f)),[i,e]}function Xc(i,e,t,n){let s=da(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var qc=.1,pf={mode:3,pad:qc},co={pad:0,soft:null,mode:0},Og={min:co,max:co};function ha(i,e,t,n){return ma(t)?mf(i,e,t):(co.pad=t,co.soft=n?0:null,co.mode=n?3:0,mf(i,e,Og))}function gt(i,e){return i??e}function Bg(i,e,t){for(e=gt(e,0),t=gt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function mf(i,e,t){let n=t.min,s=t.max,r=gt(n.pad,0),o=gt(s.pad,0),a=gt(n.hard,-Pt),l=gt(s.hard,Pt),c=gt(n.soft,Pt),u=gt(s.soft,-Pt),h=gt(n.mode,0),f=gt(s.mode,0),d=e-i,_=Fi(d),M=An(rn(i),rn(e)),m=Fi(M),p=rn(m-_);(d<1e-24||p>10)&&(d=0,(i==0||e==0)&&(d=1e-24,h==2&&c!=Pt&&(r=0),f==2&&u!=-Pt&&(o=0)));let E=d||M||1e3,w=Fi(E),y=pr(10,Hn(w)),F=E*(d==0?i==0?.1:1:r),I=It($f(i-F,y/10),24),L=i>=c&&(h==1||h==3&&I<=c||h==2&&I>=c)?c:Pt,B=An(a,I<L&&i>=L?L:ci(L,I)),T=E*(d==0?e==0?.1:1:o),b=It(pa(e+T,y/10),24),R=e<=u&&(f==1||f==3&&b>=u||f==2&&b<=u)?u:-Pt,X=ci(l,b>R&&e<=R?R:An(R,b));return B==X&&B==0&&(X=100),[B,X]}var kg=new Intl.NumberFormat(xr?Dg.language:"en-US"),Yc=i=>kg.format(i),Gn=Math,la=Gn.PI,rn=Gn.abs,Hn=Gn.floor,sn=Gn.round,ei=Gn.ceil,ci=Gn.min,An=Gn.max,pr=Gn.pow,gf=Gn.sign,Fi=Gn.log10,Wf=Gn.log2,zg=(i,e=1)=>Gn.sinh(i)*e,Cc=(i,e=1)=>Gn.asinh(i/e),Pt=1/0;function _f(i){return(Fi((i^i>>31)-(i>>31))|0)+1}function Nc(i,e,t){return ci(An(i,e),t)}function Xf(i){return typeof i=="function"}function at(i){return Xf(i)?i:()=>i}var Vg=()=>{},qf=i=>i,Yf=(i,e)=>e,Hg=i=>null,xf=i=>!0,vf=(i,e)=>i==e,Gg=/\.\d*?(?=9{6,}|0{6,})/gm,Is=i=>{if(Jf(i)||ss.has(i))return i;let e=`${i}`,t=e.match(Gg);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Is(s)}e${r}`}return It(i,n)};function As(i,e){return Is(It(Is(i/e))*e)}function pa(i,e){return Is(ei(Is(i/e))*e)}function $f(i,e){return Is(Hn(Is(i/e))*e)}function It(i,e=0){if(Jf(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return sn(n)/t}var ss=new Map;function Zf(i){return((""+i).split(".")[1]||"").length}function uo(i,e,t,n){let s=[],r=n.map(Zf);for(let o=e;o<t;o++){let a=rn(o),l=It(pr(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?u:It(u,h);s.push(f),ss.set(f,h)}}return s}var ho={},$c=[],mr=[null,null],is=Array.isArray,Jf=Number.isInteger,Wg=i=>i===void 0;function yf(i){return typeof i=="string"}function ma(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function Xg(i){return i!=null&&typeof i=="object"}var qg=Object.getPrototypeOf(Uint8Array),Kf="__proto__";function gr(i,e=ma){let t;if(is(i)){let n=i.find(s=>s!=null);if(is(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=gr(i[s],e)}else t=i.slice()}else if(i instanceof qg)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Kf&&(t[n]=gr(i[n],e))}else t=i;return t}function $t(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Kf&&(ma(i[s])?$t(i[s],gr(n[s])):i[s]=gr(n[s]))}return i}var Yg=0,$g=1,Zg=2;function Jg(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function Kg(i,e){if(e0(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return t0(o[0])||(o=Qg(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:$g,d=[];for(let _=0;_<u.length;_++){let M=u[_],m=r.get(l[_]);M===null?f!=Yg&&(h[m]=M,f==Zg&&d.push(m)):h[m]=M}Jg(h,d,s),n.push(h)}}return n}var jg=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Qg(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function e0(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function t0(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=An(1,Hn((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var jf=["January","February","March","April","May","June","July","August","September","October","November","December"],Qf=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function ed(i){return i.slice(0,3)}var n0=Qf.map(ed),i0=jf.map(ed),s0={MMMM:jf,MMM:i0,WWWW:Qf,WWW:n0};function ro(i){return(i<10?"0":"")+i}function r0(i){return(i<10?"00":i<100?"0":"")+i}var o0={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>ro(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>ro(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>ro(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>ro(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>ro(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>r0(i.getMilliseconds())};function Zc(i,e){e=e||s0;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?o0[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var a0=new Intl.DateTimeFormat().resolvedOptions().timeZone;function l0(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==a0?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var td=i=>i%1==0,ua=[1,2,2.5,5],c0=uo(10,-32,0,ua),nd=uo(10,0,32,ua),h0=nd.filter(td),Cs=c0.concat(nd),Jc=`
`,id="{YYYY}",Mf=Jc+id,sd="{M}/{D}",lo=Jc+sd,oa=lo+"/{YY}",rd="{aa}",u0="{h}:{mm}",fr=u0+rd,bf=Jc+fr,Sf=":{ss}",bt=null;function od(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?uo(10,0,3,ua).filter(td):uo(10,-3,0,ua)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,id,bt,bt,bt,bt,bt,bt,1],[s*28,"{MMM}",Mf,bt,bt,bt,bt,bt,1],[s,sd,Mf,bt,bt,bt,bt,bt,1],[n,"{h}"+rd,oa,bt,lo,bt,bt,bt,1],[t,fr,oa,bt,lo,bt,bt,bt,1],[e,Sf,oa+" "+fr,bt,lo+" "+fr,bt,bf,bt,1],[i,Sf+".{fff}",oa+" "+fr,bt,lo+" "+fr,bt,bf,bt,1]];function u(h){return(f,d,_,M,m,p)=>{let E=[],w=m>=o,y=m>=r&&m<o,F=h(_),I=It(F*i,3),L=Rc(F.getFullYear(),w?0:F.getMonth(),y||w?1:F.getDate()),B=It(L*i,3);if(y||w){let T=y?m/r:0,b=w?m/o:0,R=I==B?I:It(Rc(L.getFullYear()+b,L.getMonth()+T,1)*i,3),X=new Date(sn(R/i)),k=X.getFullYear(),G=X.getMonth();for(let Y=0;R<=M;Y++){let q=Rc(k+b*Y,G+T*Y,1),K=q-h(It(q*i,3));R=It((+q+K)*i,3),R<=M&&E.push(R)}}else{let T=m>=s?s:m,b=Hn(_)-Hn(I),R=B+b+pa(I-B,T);E.push(R);let X=h(R),k=X.getHours()+X.getMinutes()/t+X.getSeconds()/n,G=m/n,Y=f.axes[d]._space,q=p/Y;for(;R=It(R+m,i==1?0:3),!(R>M);)if(G>1){let K=Hn(It(k+G,6))%24,le=h(R).getHours()-K;le>1&&(le=-1),R-=le*n,k=(k+G)%24;let ge=E[E.length-1];It((R-ge)/m,3)*q>=.7&&E.push(R)}else E.push(R)}return E}}return[l,c,u]}var[f0,d0,p0]=od(1),[m0,g0,_0]=od(.001);uo(2,-53,53,[1]);function wf(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Tf(i,e){return(t,n,s,r,o)=>{let a=e.find(_=>o>=_[0])||e[e.length-1],l,c,u,h,f,d;return n.map(_=>{let M=i(_),m=M.getFullYear(),p=M.getMonth(),E=M.getDate(),w=M.getHours(),y=M.getMinutes(),F=M.getSeconds(),I=m!=l&&a[2]||p!=c&&a[3]||E!=u&&a[4]||w!=h&&a[5]||y!=f&&a[6]||F!=d&&a[7]||a[1];return l=m,c=p,u=E,h=w,f=y,d=F,I(M)})}}function x0(i,e){let t=Zc(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Rc(i,e,t){return new Date(i,e,t)}function Ef(i,e){return e(i)}var v0="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Af(i,e){return(t,n,s,r)=>r==null?Gc:e(i(n))}function y0(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function M0(i,e){return i.series[e].fill(i,e)}var b0={show:!0,live:!0,isolate:!1,mount:Vg,markers:{show:!0,width:2,stroke:y0,fill:M0,dash:"solid"},idx:null,idxs:null,values:[]};function S0(i,e){let t=i.cursor.points,n=Qn(),s=t.size(i,e);Ot(n,oo,s),Ot(n,ao,s);let r=s/-2;Ot(n,"marginLeft",r),Ot(n,"marginTop",r);let o=t.width(i,e,s);return o&&Ot(n,"borderWidth",o),n}function w0(i,e){let t=i.series[e].points;return t._fill||t._stroke}function T0(i,e){let t=i.series[e].points;return t._stroke||t._fill}function E0(i,e){return i.series[e].points.size}var Pc=[0,0];function A0(i,e,t){return Pc[0]=e,Pc[1]=t,Pc}function aa(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Ic(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var C0={show:!0,x:!0,y:!0,lock:!1,move:A0,points:{one:!1,show:S0,size:E0,width:0,stroke:T0,fill:w0},bind:{mousedown:aa,mouseup:aa,click:aa,dblclick:aa,mousemove:Ic,mouseleave:Ic,mouseenter:Ic},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},ad={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Kc=$t({},ad,{filter:Yf}),ld=$t({},Kc,{size:10}),cd=$t({},ad,{show:!1}),jc='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',hd="bold "+jc,ud=1.5,Cf={show:!0,scale:"x",stroke:Hc,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:hd,side:2,grid:Kc,ticks:ld,border:cd,font:jc,lineGap:ud,rotate:0},R0="Value",P0="Time",Rf={show:!0,scale:"x",auto:!1,sorted:1,min:Pt,max:-Pt,idxs:[]};function I0(i,e,t,n,s){return e.map(r=>r==null?"":Yc(r))}function L0(i,e,t,n,s,r,o){let a=[],l=ss.get(s)||0;t=o?t:It(pa(t,s),l);for(let c=t;c<=n;c=It(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Oc(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?Fi:Wf,u=Hn(c(t));s=pr(l,u),l==10&&(s=Cs[li(s,Cs)]);let h=t,f=s*l;l==10&&(f=Cs[li(f,Cs)]);do a.push(h),h=h+s,l==10&&!ss.has(h)&&(h=It(h,ss.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Cs[li(f,Cs)]));while(h<=n);return a}function D0(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?Oc(i,e,An(l,t),n,s):[l],u=n>=0&&t<=0?[0]:[];return(t<-l?Oc(i,e,An(l,-n),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var fd=/./,U0=/[12357]/,F0=/[125]/,Pf=/1/,Bc=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function N0(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?fd:l(7,o)-u>=c?U0:l(5,o)-u>=c?F0:Pf;if(h==Pf){let f=rn(l(1,o)-u);if(f<c)return Bc(e.slice().reverse(),a.distr,h,ei(c/f)).reverse()}return Bc(e,a.distr,h,1)}function O0(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=rn(l(1,o)-l(2,o));return c<a?Bc(e.slice().reverse(),3,fd,ei(a/c)).reverse():e}function B0(i,e,t,n){return n==null?Gc:e==null?"":Yc(e)}var If={show:!0,scale:"y",stroke:Hc,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:hd,side:3,grid:Kc,ticks:ld,border:cd,font:jc,lineGap:ud,rotate:0};function k0(i,e){let t=3+(i||1)*2;return It(t*e,3)}function z0(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=rn(o-r),l=i.series[e],c=a/(l.points.space*vt);return n[1]-n[0]<=c}var Lf={scale:null,auto:!0,sorted:0,min:Pt,max:-Pt},dd=(i,e,t,n,s)=>s,Df={show:!0,auto:!0,sorted:0,gaps:dd,alpha:1,facets:[$t({},Lf,{scale:"x"}),$t({},Lf,{scale:"y"})]},Uf={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:dd,alpha:1,points:{show:z0,filter:null},values:null,min:Pt,max:-Pt,idxs:[],path:null,clip:null};function V0(i,e,t,n,s){return t/10}var pd={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},H0=$t({},pd,{time:!1,ori:1}),Ff={};function md(i,e){let t=Ff[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(Ff[i]=t)),t}var _r=1,kc=2;function Ls(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,_=a.width,M=a.height,m=i.valToPosH,p=i.valToPosV;return u.ori==0?t(s,l,c,u,h,m,p,f,d,_,M,_a,vr,va,_d,vd):t(s,l,c,u,h,p,m,d,f,M,_,xa,yr,th,xd,yd)}function Qc(i,e){let t=0,n=0,s=gt(i.bands,$c);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function G0(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ni(i,e,t,n,s,r){return Ls(i,e,(o,a,l,c,u,h,f,d,_,M,m)=>{let p=o.pxRound,E=c.dir*(c.ori==0?1:-1),w=c.ori==0?vr:yr,y,F;E==1?(y=t,F=n):(y=n,F=t);let I=p(h(a[y],c,M,d)),L=p(f(l[y],u,m,_)),B=p(h(a[F],c,M,d)),T=p(f(r==1?u.max:u.min,u,m,_)),b=new Path2D(s);return w(b,B,T),w(b,I,T),w(b,I,L),b})}function ga(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?va:th,l=t;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function W0(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function eh(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=n&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=r(i[h]),_=f==h?d:r(i[f]),M=h-s;d=o<=0&&M>=0&&M<l?r(i[M]):d;let p=f+s;_=o>=0&&p>=0&&p<l?r(i[p]):_,_>=d&&a.push([d,_])}return a}function Nf(i){return i==0?qf:i==1?sn:e=>As(e,i)}function gd(i){let e=i==0?_a:xa,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=ci(c,a/2,l/2),u=ci(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var _a=(i,e,t)=>{i.moveTo(e,t)},xa=(i,e,t)=>{i.moveTo(t,e)},vr=(i,e,t)=>{i.lineTo(e,t)},yr=(i,e,t)=>{i.lineTo(t,e)},va=gd(0),th=gd(1),_d=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},xd=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},vd=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},yd=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function Md(i){return(e,t,n,s,r)=>Ls(e,t,(o,a,l,c,u,h,f,d,_,M,m)=>{let{pxRound:p,points:E}=o,w,y;c.ori==0?(w=_a,y=_d):(w=xa,y=xd);let F=It(E.width*vt,3),I=(E.size-E.width)/2*vt,L=It(I*2,3),B=new Path2D,T=new Path2D,{left:b,top:R,width:X,height:k}=e.bbox;va(T,b-L,R-L,X+L*2,k+L*2);let G=Y=>{if(l[Y]!=null){let q=p(h(a[Y],c,M,d)),K=p(f(l[Y],u,m,_));w(B,q+I,K),y(B,q,K,I,0,la*2)}};if(r)r.forEach(G);else for(let Y=n;Y<=s;Y++)G(Y);return{stroke:F>0?B:null,fill:B,clip:T,flags:_r|kc}})}function bd(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var X0=bd(vr),q0=bd(yr);function Sd(i){let e=gt(i?.alignGaps,0);return(t,n,s,r)=>Ls(t,n,(o,a,l,c,u,h,f,d,_,M,m)=>{[s,r]=fa(l,s,r);let p=o.pxRound,E=k=>p(h(k,c,M,d)),w=k=>p(f(k,u,m,_)),y,F;c.ori==0?(y=vr,F=X0):(y=yr,F=q0);let I=c.dir*(c.ori==0?1:-1),L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:_r},B=L.stroke,T=!1;if(r-s>=M*4){let k=pe=>t.posToVal(pe,c.key,!0),G=null,Y=null,q,K,j,ce=E(a[I==1?s:r]),le=E(a[s]),ge=E(a[r]),be=k(I==1?le+1:ge-1);for(let pe=I==1?s:r;pe>=s&&pe<=r;pe+=I){let Q=a[pe],_e=(I==1?Q<be:Q>be)?ce:E(Q),oe=l[pe];_e==ce?oe!=null?(K=oe,G==null?(y(B,_e,w(K)),q=G=Y=K):K<G?G=K:K>Y&&(Y=K)):oe===null&&(T=!0):(G!=null&&F(B,ce,w(G),w(Y),w(q),w(K)),oe!=null?(K=oe,y(B,_e,w(K)),G=Y=q=K):(G=Y=null,oe===null&&(T=!0)),ce=_e,be=k(ce+I))}G!=null&&G!=Y&&j!=ce&&F(B,ce,w(G),w(Y),w(q),w(K))}else for(let k=I==1?s:r;k>=s&&k<=r;k+=I){let G=l[k];G===null?T=!0:G!=null&&y(B,E(a[k]),w(G))}let[R,X]=Qc(t,n);if(o.fill!=null||R!=0){let k=L.fill=new Path2D(B),G=o.fillTo(t,n,o.min,o.max,R),Y=w(G),q=E(a[s]),K=E(a[r]);I==-1&&([K,q]=[q,K]),y(k,K,Y),y(k,q,Y)}if(!o.spanGaps){let k=[];T&&k.push(...eh(a,l,s,r,I,E,e)),L.gaps=k=o.gaps(t,n,s,r,k),L.clip=ga(k,c.ori,d,_,M,m)}return X!=0&&(L.band=X==2?[Ni(t,n,s,r,B,-1),Ni(t,n,s,r,B,1)]:Ni(t,n,s,r,B,X)),L})}function Y0(i){let e=gt(i.align,1),t=gt(i.ascDesc,!1),n=gt(i.alignGaps,0),s=gt(i.extend,!1);return(r,o,a,l)=>Ls(r,o,(c,u,h,f,d,_,M,m,p,E,w)=>{[a,l]=fa(h,a,l);let y=c.pxRound,{left:F,width:I}=r.bbox,L=le=>y(_(le,f,E,m)),B=le=>y(M(le,d,w,p)),T=f.ori==0?vr:yr,b={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:_r},R=b.stroke,X=f.dir*(f.ori==0?1:-1),k=B(h[X==1?a:l]),G=L(u[X==1?a:l]),Y=G,q=G;s&&e==-1&&(q=F,T(R,q,k)),T(R,G,k);for(let le=X==1?a:l;le>=a&&le<=l;le+=X){let ge=h[le];if(ge==null)continue;let be=L(u[le]),pe=B(ge);e==1?T(R,be,k):T(R,Y,pe),T(R,be,pe),k=pe,Y=be}let K=Y;s&&e==1&&(K=F+I,T(R,K,k));let[j,ce]=Qc(r,o);if(c.fill!=null||j!=0){let le=b.fill=new Path2D(R),ge=c.fillTo(r,o,c.min,c.max,j),be=B(ge);T(le,K,be),T(le,q,be)}if(!c.spanGaps){let le=[];le.push(...eh(u,h,a,l,X,L,n));let ge=c.width*vt/2,be=t||e==1?ge:-ge,pe=t||e==-1?-ge:ge;le.forEach(Q=>{Q[0]+=be,Q[1]+=pe}),b.gaps=le=c.gaps(r,o,a,l,le),b.clip=ga(le,f.ori,m,p,E,w)}return ce!=0&&(b.band=ce==2?[Ni(r,o,a,l,R,-1),Ni(r,o,a,l,R,1)]:Ni(r,o,a,l,R,ce)),b})}function Of(i,e,t,n,s,r,o=Pt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let u=rn(i[l]-i[a]);u<c&&(c=u,o=rn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function $0(i){i=i||ho;let e=gt(i.size,[.6,Pt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=at(s),o=1-e[0],a=gt(e[1],Pt),l=gt(e[2],1),c=gt(i.disp,ho),u=gt(i.each,d=>{}),{fill:h,stroke:f}=c;return(d,_,M,m)=>Ls(d,_,(p,E,w,y,F,I,L,B,T,b,R)=>{let X=p.pxRound,k=t,G=n*vt,Y=a*vt,q=l*vt,K,j;y.ori==0?[K,j]=r(d,_):[j,K]=r(d,_);let ce=y.dir*(y.ori==0?1:-1),le=y.ori==0?va:th,ge=y.ori==0?u:(D,Z,te,ee,Fe,me,Ie)=>{u(D,Z,te,Fe,ee,Ie,me)},be=gt(d.bands,$c).find(D=>D.series[0]==_),pe=be!=null?be.dir:0,Q=p.fillTo(d,_,p.min,p.max,pe),he=X(L(Q,F,R,T)),_e,oe,De,Je=b,Te=X(p.width*vt),ut=!1,ft=null,Qe=null,U=null,Ht=null;h!=null&&(Te==0||f!=null)&&(ut=!0,ft=h.values(d,_,M,m),Qe=new Map,new Set(ft).forEach(D=>{D!=null&&Qe.set(D,new Path2D)}),Te>0&&(U=f.values(d,_,M,m),Ht=new Map,new Set(U).forEach(D=>{D!=null&&Ht.set(D,new Path2D)})));let{x0:rt,size:dt}=c;if(rt!=null&&dt!=null){k=1,E=rt.values(d,_,M,m),rt.unit==2&&(E=E.map(te=>d.posToVal(B+te*b,y.key,!0)));let D=dt.values(d,_,M,m);dt.unit==2?oe=D[0]*b:oe=I(D[0],y,b,B)-I(0,y,b,B),Je=Of(E,w,I,y,b,B,Je),De=Je-oe+G}else Je=Of(E,w,I,y,b,B,Je),De=Je*o+G,oe=Je-De;De<1&&(De=0),Te>=oe/2&&(Te=0),De<5&&(X=qf);let Oe=De>0,tt=Je-De-(Oe?Te:0);oe=X(Nc(tt,q,Y)),_e=(k==0?oe/2:k==ce?0:oe)-k*ce*((k==0?G/2:0)+(Oe?Te/2:0));let Pe={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},$e=ut?null:new Path2D,St=null;if(be!=null)St=d.data[be.series[1]];else{let{y0:D,y1:Z}=c;D!=null&&Z!=null&&(w=Z.values(d,_,M,m),St=D.values(d,_,M,m))}let P=K*oe,x=j*oe;for(let D=ce==1?M:m;D>=M&&D<=m;D+=ce){let Z=w[D];if(Z==null)continue;if(St!=null){let xe=St[D]??0;if(Z-xe==0)continue;he=L(xe,F,R,T)}let te=y.distr!=2||c!=null?E[D]:D,ee=I(te,y,b,B),Fe=L(gt(Z,Q),F,R,T),me=X(ee-_e),Ie=X(An(Fe,he)),Ee=X(ci(Fe,he)),ie=Ie-Ee;if(Z!=null){let xe=Z<0?x:P,Be=Z<0?P:x;ut?(Te>0&&U[D]!=null&&le(Ht.get(U[D]),me,Ee+Hn(Te/2),oe,An(0,ie-Te),xe,Be),ft[D]!=null&&le(Qe.get(ft[D]),me,Ee+Hn(Te/2),oe,An(0,ie-Te),xe,Be)):le($e,me,Ee+Hn(Te/2),oe,An(0,ie-Te),xe,Be),ge(d,_,D,me-Te/2,Ee,oe+Te,ie)}}return Te>0?Pe.stroke=ut?Ht:$e:ut||(Pe._fill=p.width==0?p._fill:p._stroke??p._fill,Pe.width=0),Pe.fill=ut?Qe:$e,Pe})}function Z0(i,e){let t=gt(e?.alignGaps,0);return(n,s,r,o)=>Ls(n,s,(a,l,c,u,h,f,d,_,M,m,p)=>{[r,o]=fa(c,r,o);let E=a.pxRound,w=K=>E(f(K,u,m,_)),y=K=>E(d(K,h,p,M)),F,I,L;u.ori==0?(F=_a,L=vr,I=vd):(F=xa,L=yr,I=yd);let B=u.dir*(u.ori==0?1:-1),T=w(l[B==1?r:o]),b=T,R=[],X=[];for(let K=B==1?r:o;K>=r&&K<=o;K+=B)if(c[K]!=null){let ce=l[K],le=w(ce);R.push(b=le),X.push(y(c[K]))}let k={stroke:i(R,X,F,L,I,E),fill:null,clip:null,band:null,gaps:null,flags:_r},G=k.stroke,[Y,q]=Qc(n,s);if(a.fill!=null||Y!=0){let K=k.fill=new Path2D(G),j=a.fillTo(n,s,a.min,a.max,Y),ce=y(j);L(K,b,ce),L(K,T,ce)}if(!a.spanGaps){let K=[];K.push(...eh(l,c,r,o,B,w,t)),k.gaps=K=a.gaps(n,s,r,o,K),k.clip=ga(K,u.ori,_,M,m,p)}return q!=0&&(k.band=q==2?[Ni(n,s,r,o,G,-1),Ni(n,s,r,o,G,1)]:Ni(n,s,r,o,G,q)),k})}function J0(i){return Z0(K0,i)}function K0(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+h[f]/3,e[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,i[f+1],e[f+1])}return a}var zc=new Set;function Bf(){for(let i of zc)i.syncRect(!0)}xr&&(Ps(Ig,dr,Bf),Ps(Lg,dr,Bf,!0),Ps(ca,dr,()=>{pn.pxRatio=vt}));var j0=Sd(),Q0=Md();function kf(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Vc(r,o,e,t))}function e_(i,e){return i.map((t,n)=>n==0?{}:$t({},e,t))}function Vc(i,e,t,n){return $t({},e==0?t:n,i)}function wd(i,e,t){return e==null?mr:[e,t]}var t_=wd;function n_(i,e,t){return e==null?mr:ha(e,t,qc,!0)}function Td(i,e,t,n){return e==null?mr:da(e,t,i.scales[n].log,!1)}var i_=Td;function Ed(i,e,t,n){return e==null?mr:Xc(e,t,i.scales[n].log,!1)}var s_=Ed;function r_(i,e,t,n,s){let r=An(_f(i),_f(e)),o=e-i,a=li(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?ss.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function zf(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=sn((t=+s)*vt))+"px"),[i,e,t]}function o_(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=It(e[2]*vt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function pn(i,e,t){let n={mode:gt(i.mode,1)},s=n.mode;function r(g,v,A,C){let O=v.valToPct(g);return C+A*(v.dir==-1?1-O:O)}function o(g,v,A,C){let O=v.valToPct(g);return C+A*(v.dir==-1?O:1-O)}function a(g,v,A,C){return v.ori==0?r(g,v,A,C):o(g,v,A,C)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Qn(dg);if(i.id!=null&&(c.id=i.id),Vn(c,i.class),i.title){let g=Qn(gg,c);g.textContent=i.title}let u=ai("canvas"),h=n.ctx=u.getContext("2d"),f=Qn(_g,c);Ps("click",f,g=>{g.target===_&&(Ut!=or||kt!=ar)&&dn.click(n,g)},!0);let d=n.under=Qn(xg,f);f.appendChild(u);let _=n.over=Qn(vg,f);i=gr(i);let M=+gt(i.pxAlign,1),m=Nf(M);(i.plugins||[]).forEach(g=>{g.opts&&(i=g.opts(n,i)||i)});let p=i.ms||.001,E=n.series=s==1?kf(i.series||[],Rf,Uf,!1):e_(i.series||[null],Df),w=n.axes=kf(i.axes||[],Cf,If,!0),y=n.scales={},F=n.bands=i.bands||[];F.forEach(g=>{g.fill=at(g.fill||null),g.dir=gt(g.dir,-1)});let I=s==2?E[1].facets[0].scale:E[0].scale,L={axes:jm,series:bn},B=(i.drawOrder||["axes","series"]).map(g=>L[g]);function T(g){let v=g.distr==3?A=>Fi(A>0?A:g.clamp(n,A,g.min,g.max,g.key)):g.distr==4?A=>Cc(A,g.asinh):g.distr==100?A=>g.fwd(A):A=>A;return A=>{let C=v(A),{_min:O,_max:H}=g,ne=H-O;return(C-O)/ne}}function b(g){let v=y[g];if(v==null){let A=(i.scales||ho)[g]||ho;if(A.from!=null){b(A.from);let C=$t({},y[A.from],A,{key:g});C.valToPct=T(C),y[g]=C}else{v=y[g]=$t({},g==I?pd:H0,A),v.key=g;let C=v.time,O=v.range,H=is(O);if((g!=I||s==2&&!C)&&(H&&(O[0]==null||O[1]==null)&&(O={min:O[0]==null?pf:{mode:1,hard:O[0],soft:O[0]},max:O[1]==null?pf:{mode:1,hard:O[1],soft:O[1]}},H=!1),!H&&ma(O))){let ne=O;O=(ae,de,we)=>de==null?mr:ha(de,we,ne)}v.range=at(O||(C?t_:g==I?v.distr==3?i_:v.distr==4?s_:wd:v.distr==3?Td:v.distr==4?Ed:n_)),v.auto=at(H?!1:v.auto),v.clamp=at(v.clamp||V0),v._min=v._max=null,v.valToPct=T(v)}}}b("x"),b("y"),s==1&&E.forEach(g=>{b(g.scale)}),w.forEach(g=>{b(g.scale)});for(let g in i.scales)b(g);let R=y[I],X=R.distr,k,G;R.ori==0?(Vn(c,pg),k=r,G=o):(Vn(c,mg),k=o,G=r);let Y={};for(let g in y){let v=y[g];(v.min!=null||v.max!=null)&&(Y[g]={min:v.min,max:v.max},v.min=v.max=null)}let q=i.tzDate||(g=>new Date(sn(g/p))),K=i.fmtDate||Zc,j=p==1?p0(q):_0(q),ce=Tf(q,wf(p==1?d0:g0,K)),le=Af(q,Ef(v0,K)),ge=[],be=n.legend=$t({},b0,i.legend),pe=n.cursor=$t({},C0,{drag:{y:s==2}},i.cursor),Q=be.show,he=pe.show,_e=be.markers;be.idxs=ge,_e.width=at(_e.width),_e.dash=at(_e.dash),_e.stroke=at(_e.stroke),_e.fill=at(_e.fill);let oe,De,Je,Te=[],ut=[],ft,Qe=!1,U={};if(be.live){let g=E[1]?E[1].values:null;Qe=g!=null,ft=Qe?g(n,1,0):{_:0};for(let v in ft)U[v]=Gc}if(Q)if(oe=ai("table",Tg,c),Je=ai("tbody",null,oe),be.mount(n,oe),Qe){De=ai("thead",null,oe,Je);let g=ai("tr",null,De);ai("th",null,g);for(var Ht in ft)ai("th",ef,g).textContent=Ht}else Vn(oe,Ag),be.live&&Vn(oe,Eg);let rt={show:!0},dt={show:!1};function Oe(g,v){if(v==0&&(Qe||!be.live||s==2))return mr;let A=[],C=ai("tr",Cg,Je,Je.childNodes[v]);Vn(C,g.class),g.show||Vn(C,Rs);let O=ai("th",null,C);if(_e.show){let ae=Qn(Rg,O);if(v>0){let de=_e.width(n,v);de&&(ae.style.border=de+"px "+_e.dash(n,v)+" "+_e.stroke(n,v)),ae.style.background=_e.fill(n,v)}}let H=Qn(ef,O);g.label instanceof HTMLElement?H.appendChild(g.label):H.textContent=g.label,v>0&&(_e.show||(H.style.color=g.width>0?_e.stroke(n,v):_e.fill(n,v)),Pe("click",O,ae=>{if(pe._lock)return;Qt(ae);let de=E.indexOf(g);if((ae.ctrlKey||ae.metaKey)!=be.isolate){let we=E.some((Ae,Ue)=>Ue>0&&Ue!=de&&Ae.show);E.forEach((Ae,Ue)=>{Ue>0&&mi(Ue,we?Ue==de?rt:dt:rt,!0,Yt.setSeries)})}else mi(de,{show:!g.show},!0,Yt.setSeries)},!1),Pi&&Pe(rf,O,ae=>{pe._lock||(Qt(ae),mi(E.indexOf(g),cr,!0,Yt.setSeries))},!1));for(var ne in ft){let ae=ai("td",Pg,C);ae.textContent="--",A.push(ae)}return[C,A]}let tt=new Map;function Pe(g,v,A,C=!0){let O=tt.get(v)||{},H=pe.bind[g](n,v,A,C);H&&(Ps(g,v,O[g]=H),tt.set(v,O))}function $e(g,v,A){let C=tt.get(v)||{};for(let O in C)(g==null||O==g)&&(Fc(O,v,C[O]),delete C[O]);g==null&&tt.delete(v)}let St=0,P=0,x=0,D=0,Z=0,te=0,ee=Z,Fe=te,me=x,Ie=D,Ee=0,ie=0,xe=0,Be=0;n.bbox={};let He=!1,ve=!1,We=!1,N=!1,ye=!1,re=!1;function Le(g,v,A){(A||g!=n.width||v!=n.height)&&ue(g,v),nr(!1),We=!0,ve=!0,ir()}function ue(g,v){n.width=St=x=g,n.height=P=D=v,Z=te=0,At(),_t();let A=n.bbox;Ee=A.left=As(Z*vt,.5),ie=A.top=As(te*vt,.5),xe=A.width=As(x*vt,.5),Be=A.height=As(D*vt,.5)}let se=3;function Ne(){let g=!1,v=0;for(;!g;){v++;let A=Jm(v),C=Km(v);g=v==se||A&&C,g||(ue(n.width,n.height),ve=!0)}}function Ke({width:g,height:v}){Le(g,v)}n.setSize=Ke;function At(){let g=!1,v=!1,A=!1,C=!1;w.forEach((O,H)=>{if(O.show&&O._show){let{side:ne,_size:ae}=O,de=ne%2,we=O.label!=null?O.labelSize:0,Ae=ae+we;Ae>0&&(de?(x-=Ae,ne==3?(Z+=Ae,C=!0):A=!0):(D-=Ae,ne==0?(te+=Ae,g=!0):v=!0))}}),di[0]=g,di[1]=A,di[2]=v,di[3]=C,x-=pi[1]+pi[3],Z+=pi[3],D-=pi[2]+pi[0],te+=pi[0]}function _t(){let g=Z+x,v=te+D,A=Z,C=te;function O(H,ne){switch(H){case 1:return g+=ne,g-ne;case 2:return v+=ne,v-ne;case 3:return A-=ne,A+ne;case 0:return C-=ne,C+ne}}w.forEach((H,ne)=>{if(H.show&&H._show){let ae=H.side;H._pos=O(ae,H._size),H.label!=null&&(H._lpos=O(ae,H.labelSize))}})}if(pe.dataIdx==null){let g=pe.hover,v=g.skip=new Set(g.skip??[]);v.add(void 0);let A=g.prox=at(g.prox),C=g.bias??(g.bias=0);pe.dataIdx=(O,H,ne,ae)=>{if(H==0)return ne;let de=ne,we=A(O,H,ne,ae)??Pt,Ae=we>=0&&we<Pt,Ue=R.ori==0?x:D,je=pe.left,xt=e[0],mt=e[H];if(v.has(mt[ne])){de=null;let ot=null,Ye=null,Ve;if(C==0||C==-1)for(Ve=ne;ot==null&&Ve-- >0;)v.has(mt[Ve])||(ot=Ve);if(C==0||C==1)for(Ve=ne;Ye==null&&Ve++<mt.length;)v.has(mt[Ve])||(Ye=Ve);if(ot!=null||Ye!=null)if(Ae){let Nt=ot==null?-1/0:k(xt[ot],R,Ue,0),Gt=Ye==null?1/0:k(xt[Ye],R,Ue,0),un=je-Nt,Et=Gt-je;un<=Et?un<=we&&(de=ot):Et<=we&&(de=Ye)}else de=Ye==null?ot:ot==null?Ye:ne-ot<=Ye-ne?ot:Ye}else Ae&&rn(je-k(xt[ne],R,Ue,0))>we&&(de=null);return de}}let Qt=g=>{pe.event=g};pe.idxs=ge,pe._lock=!1;let Lt=pe.points;Lt.show=at(Lt.show),Lt.size=at(Lt.size),Lt.stroke=at(Lt.stroke),Lt.width=at(Lt.width),Lt.fill=at(Lt.fill);let On=n.focus=$t({},i.focus||{alpha:.3},pe.focus),Pi=On.prox>=0,Pn=Pi&&Lt.one,gn=[],Ii=[],Li=[];function bs(g,v){let A=Lt.show(n,v);if(A instanceof HTMLElement)return Vn(A,wg),Vn(A,g.class),vi(A,-10,-10,x,D),_.insertBefore(A,gn[v]),A}function Qr(g,v){if(s==1||v>0){let A=s==1&&y[g.scale].time,C=g.value;g.value=A?yf(C)?Af(q,Ef(C,K)):C||le:C||B0,g.label=g.label||(A?P0:R0)}if(Pn||v>0){g.width=g.width==null?1:g.width,g.paths=g.paths||j0||Hg,g.fillTo=at(g.fillTo||G0),g.pxAlign=+gt(g.pxAlign,M),g.pxRound=Nf(g.pxAlign),g.stroke=at(g.stroke||null),g.fill=at(g.fill||null),g._stroke=g._fill=g._paths=g._focus=null;let A=k0(An(1,g.width),1),C=g.points=$t({},{size:A,width:An(1,A*.2),stroke:g.stroke,space:A*2,paths:Q0,_stroke:null,_fill:null},g.points);C.show=at(C.show),C.filter=at(C.filter),C.fill=at(C.fill),C.stroke=at(C.stroke),C.paths=at(C.paths),C.pxAlign=g.pxAlign}if(Q){let A=Oe(g,v);Te.splice(v,0,A[0]),ut.splice(v,0,A[1]),be.values.push(null)}if(he){ge.splice(v,0,null);let A=null;Pn?v==0&&(A=bs(g,v)):v>0&&(A=bs(g,v)),gn.splice(v,0,A),Ii.splice(v,0,0),Li.splice(v,0,0)}hn("addSeries",v)}function tr(g,v){v=v??E.length,g=s==1?Vc(g,v,Rf,Uf):Vc(g,v,{},Df),E.splice(v,0,g),Qr(E[v],v)}n.addSeries=tr;function ea(g){if(E.splice(g,1),Q){be.values.splice(g,1),ut.splice(g,1);let v=Te.splice(g,1)[0];$e(null,v.firstChild),v.remove()}he&&(ge.splice(g,1),gn.splice(g,1)[0].remove(),Ii.splice(g,1),Li.splice(g,1)),hn("delSeries",g)}n.delSeries=ea;let di=[!1,!1,!1,!1];function dc(g,v){if(g._show=g.show,g.show){let A=g.side%2,C=y[g.scale];C==null&&(g.scale=A?E[1].scale:I,C=y[g.scale]);let O=C.time;g.size=at(g.size),g.space=at(g.space),g.rotate=at(g.rotate),is(g.incrs)&&g.incrs.forEach(ne=>{!ss.has(ne)&&ss.set(ne,Zf(ne))}),g.incrs=at(g.incrs||(C.distr==2?h0:O?p==1?f0:m0:Cs)),g.splits=at(g.splits||(O&&C.distr==1?j:C.distr==3?Oc:C.distr==4?D0:L0)),g.stroke=at(g.stroke),g.grid.stroke=at(g.grid.stroke),g.ticks.stroke=at(g.ticks.stroke),g.border.stroke=at(g.border.stroke);let H=g.values;g.values=is(H)&&!is(H[0])?at(H):O?is(H)?Tf(q,wf(H,K)):yf(H)?x0(q,H):H||ce:H||I0,g.filter=at(g.filter||(C.distr>=3&&C.log==10?N0:C.distr==3&&C.log==2?O0:Yf)),g.font=zf(g.font),g.labelFont=zf(g.labelFont),g._size=g.size(n,null,v,0),g._space=g._rotate=g._incrs=g._found=g._splits=g._values=null,g._size>0&&(di[v]=!0,g._el=Qn(yg,f))}}function Ss(g,v,A,C){let[O,H,ne,ae]=A,de=v%2,we=0;return de==0&&(ae||H)&&(we=v==0&&!O||v==2&&!ne?sn(Cf.size/3):0),de==1&&(O||ne)&&(we=v==1&&!H||v==3&&!ae?sn(If.size/2):0),we}let ta=n.padding=(i.padding||[Ss,Ss,Ss,Ss]).map(g=>at(gt(g,Ss))),pi=n._padding=ta.map((g,v)=>g(n,v,di,0)),en,qt=null,S=null,z=s==1?E[0].idxs:null,W=null,$=!1;function V(g,v){if(e=g??[],n.data=n._data=e,s==2){en=0;for(let A=1;A<E.length;A++)en+=e[A][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),W=e[0],en=W.length;let A=e;if(X==2){A=e.slice();let C=A[0]=Array(en);for(let O=0;O<en;O++)C[O]=O}n._data=e=A}if(nr(!0),hn("setData"),X==2&&(We=!0),v!==!1){let A=R;A.auto(n,$)?fe():es(I,A.min,A.max),N=N||pe.left>=0,re=!0,ir()}}n.setData=V;function fe(){$=!0;let g,v;s==1&&(en>0?(qt=z[0]=0,S=z[1]=en-1,g=e[0][qt],v=e[0][S],X==2?(g=qt,v=S):g==v&&(X==3?[g,v]=da(g,g,R.log,!1):X==4?[g,v]=Xc(g,g,R.log,!1):R.time?v=g+sn(86400/p):[g,v]=ha(g,v,qc,!0))):(qt=z[0]=g=null,S=z[1]=v=null)),es(I,g,v)}let Me,Re,Ce,Xe,qe,ze,nt,pt,Dt,it;function Mt(g,v,A,C,O,H){g??(g=nf),A??(A=$c),C??(C="butt"),O??(O=nf),H??(H="round"),g!=Me&&(h.strokeStyle=Me=g),O!=Re&&(h.fillStyle=Re=O),v!=Ce&&(h.lineWidth=Ce=v),H!=qe&&(h.lineJoin=qe=H),C!=ze&&(h.lineCap=ze=C),A!=Xe&&h.setLineDash(Xe=A)}function Ge(g,v,A,C){v!=Re&&(h.fillStyle=Re=v),g!=nt&&(h.font=nt=g),A!=pt&&(h.textAlign=pt=A),C!=Dt&&(h.textBaseline=Dt=C)}function Ct(g,v,A,C,O=0){if(C.length>0&&g.auto(n,$)&&(v==null||v.min==null)){let H=gt(qt,0),ne=gt(S,C.length-1),ae=A.min==null?Ng(C,H,ne,O,g.distr==3):[A.min,A.max];g.min=ci(g.min,A.min=ae[0]),g.max=An(g.max,A.max=ae[1])}}let lt={min:null,max:null};function Mn(){for(let C in y){let O=y[C];Y[C]==null&&(O.min==null||Y[I]!=null&&O.auto(n,$))&&(Y[C]=lt)}for(let C in y){let O=y[C];Y[C]==null&&O.from!=null&&Y[O.from]!=null&&(Y[C]=lt)}Y[I]!=null&&nr(!0);let g={};for(let C in Y){let O=Y[C];if(O!=null){let H=g[C]=gr(y[C],Xg);if(O.min!=null)$t(H,O);else if(C!=I||s==2)if(en==0&&H.from==null){let ne=H.range(n,null,null,C);H.min=ne[0],H.max=ne[1]}else H.min=Pt,H.max=-Pt}}if(en>0){E.forEach((C,O)=>{if(s==1){let H=C.scale,ne=Y[H];if(ne==null)return;let ae=g[H];if(O==0){let de=ae.range(n,ae.min,ae.max,H);ae.min=de[0],ae.max=de[1],qt=li(ae.min,e[0]),S=li(ae.max,e[0]),S-qt>1&&(e[0][qt]<ae.min&&qt++,e[0][S]>ae.max&&S--),C.min=W[qt],C.max=W[S]}else C.show&&C.auto&&Ct(ae,ne,C,e[O],C.sorted);C.idxs[0]=qt,C.idxs[1]=S}else if(O>0&&C.show&&C.auto){let[H,ne]=C.facets,ae=H.scale,de=ne.scale,[we,Ae]=e[O],Ue=g[ae],je=g[de];Ue!=null&&Ct(Ue,Y[ae],H,we,H.sorted),je!=null&&Ct(je,Y[de],ne,Ae,ne.sorted),C.min=ne.min,C.max=ne.max}});for(let C in g){let O=g[C],H=Y[C];if(O.from==null&&(H==null||H.min==null)){let ne=O.range(n,O.min==Pt?null:O.min,O.max==-Pt?null:O.max,C);O.min=ne[0],O.max=ne[1]}}}for(let C in g){let O=g[C];if(O.from!=null){let H=g[O.from];if(H.min==null)O.min=O.max=null;else{let ne=O.range(n,H.min,H.max,C);O.min=ne[0],O.max=ne[1]}}}let v={},A=!1;for(let C in g){let O=g[C],H=y[C];if(H.min!=O.min||H.max!=O.max){H.min=O.min,H.max=O.max;let ne=H.distr;H._min=ne==3?Fi(H.min):ne==4?Cc(H.min,H.asinh):ne==100?H.fwd(H.min):H.min,H._max=ne==3?Fi(H.max):ne==4?Cc(H.max,H.asinh):ne==100?H.fwd(H.max):H.max,v[C]=A=!0}}if(A){E.forEach((C,O)=>{s==2?O>0&&v.y&&(C._paths=null):v[C.scale]&&(C._paths=null)});for(let C in v)We=!0,hn("setScale",C);he&&pe.left>=0&&(N=re=!0)}for(let C in Y)Y[C]=null}function Ji(g){let v=Nc(qt-1,0,en-1),A=Nc(S+1,0,en-1);for(;g[v]==null&&v>0;)v--;for(;g[A]==null&&A<en-1;)A++;return[v,A]}function bn(){if(en>0){let g=E.some(v=>v._focus)&&it!=On.alpha;g&&(h.globalAlpha=it=On.alpha),E.forEach((v,A)=>{if(A>0&&v.show&&(Ki(A,!1),Ki(A,!0),v._paths==null)){let C=it;it!=v.alpha&&(h.globalAlpha=it=v.alpha);let O=s==2?[0,e[A][0].length-1]:Ji(e[A]);v._paths=v.paths(n,A,O[0],O[1]),it!=C&&(h.globalAlpha=it=C)}}),E.forEach((v,A)=>{if(A>0&&v.show){let C=it;it!=v.alpha&&(h.globalAlpha=it=v.alpha),v._paths!=null&&Rt(A,!1);{let O=v._paths!=null?v._paths.gaps:null,H=v.points.show(n,A,qt,S,O),ne=v.points.filter(n,A,H,O);(H||ne)&&(v.points._paths=v.points.paths(n,A,qt,S,ne),Rt(A,!0))}it!=C&&(h.globalAlpha=it=C),hn("drawSeries",A)}}),g&&(h.globalAlpha=it=1)}}function Ki(g,v){let A=v?E[g].points:E[g];A._stroke=A.stroke(n,g),A._fill=A.fill(n,g)}function Rt(g,v){let A=v?E[g].points:E[g],{stroke:C,fill:O,clip:H,flags:ne,_stroke:ae=A._stroke,_fill:de=A._fill,_width:we=A.width}=A._paths;we=It(we*vt,3);let Ae=null,Ue=we%2/2;v&&de==null&&(de=we>0?"#fff":ae);let je=A.pxAlign==1&&Ue>0;if(je&&h.translate(Ue,Ue),!v){let xt=Ee-we/2,mt=ie-we/2,ot=xe+we,Ye=Be+we;Ae=new Path2D,Ae.rect(xt,mt,ot,Ye)}v?tn(ae,we,A.dash,A.cap,de,C,O,ne,H):In(g,ae,we,A.dash,A.cap,de,C,O,ne,Ae,H),je&&h.translate(-Ue,-Ue)}function In(g,v,A,C,O,H,ne,ae,de,we,Ae){let Ue=!1;de!=0&&F.forEach((je,xt)=>{if(je.series[0]==g){let mt=E[je.series[1]],ot=e[je.series[1]],Ye=(mt._paths||ho).band;is(Ye)&&(Ye=je.dir==1?Ye[0]:Ye[1]);let Ve,Nt=null;mt.show&&Ye&&Bg(ot,qt,S)?(Nt=je.fill(n,xt)||H,Ve=mt._paths.clip):Ye=null,tn(v,A,C,O,Nt,ne,ae,de,we,Ae,Ve,Ye),Ue=!0}}),Ue||tn(v,A,C,O,H,ne,ae,de,we,Ae)}let Sn=_r|kc;function tn(g,v,A,C,O,H,ne,ae,de,we,Ae,Ue){Mt(g,v,A,C,O),(de||we||Ue)&&(h.save(),de&&h.clip(de),we&&h.clip(we)),Ue?(ae&Sn)==Sn?(h.clip(Ue),Ae&&h.clip(Ae),ji(O,ne),nn(g,H,v)):ae&kc?(ji(O,ne),h.clip(Ue),nn(g,H,v)):ae&_r&&(h.save(),h.clip(Ue),Ae&&h.clip(Ae),ji(O,ne),h.restore(),nn(g,H,v)):(ji(O,ne),nn(g,H,v)),(de||we||Ue)&&h.restore()}function nn(g,v,A){A>0&&(v instanceof Map?v.forEach((C,O)=>{h.strokeStyle=Me=O,h.stroke(C)}):v!=null&&g&&h.stroke(v))}function ji(g,v){v instanceof Map?v.forEach((A,C)=>{h.fillStyle=Re=C,h.fill(A)}):v!=null&&g&&h.fill(v)}function Di(g,v,A,C){let O=w[g],H;if(C<=0)H=[0,0];else{let ne=O._space=O.space(n,g,v,A,C),ae=O._incrs=O.incrs(n,g,v,A,C,ne);H=r_(v,A,ae,C,ne)}return O._found=H}function pc(g,v,A,C,O,H,ne,ae,de,we){let Ae=ne%2/2;M==1&&h.translate(Ae,Ae),Mt(ae,ne,de,we,ae),h.beginPath();let Ue,je,xt,mt,ot=O+(C==0||C==3?-H:H);A==0?(je=O,mt=ot):(Ue=O,xt=ot);for(let Ye=0;Ye<g.length;Ye++)v[Ye]!=null&&(A==0?Ue=xt=g[Ye]:je=mt=g[Ye],h.moveTo(Ue,je),h.lineTo(xt,mt));h.stroke(),M==1&&h.translate(-Ae,-Ae)}function Jm(g){let v=!0;return w.forEach((A,C)=>{if(!A.show)return;let O=y[A.scale];if(O.min==null){A._show&&(v=!1,A._show=!1,nr(!1));return}else A._show||(v=!1,A._show=!0,nr(!1));let H=A.side,ne=H%2,{min:ae,max:de}=O,[we,Ae]=Di(C,ae,de,ne==0?x:D);if(Ae==0)return;let Ue=O.distr==2,je=A._splits=A.splits(n,C,ae,de,we,Ae,Ue),xt=O.distr==2?je.map(Ve=>W[Ve]):je,mt=O.distr==2?W[je[1]]-W[je[0]]:we,ot=A._values=A.values(n,A.filter(n,xt,C,Ae,mt),C,Ae,mt);A._rotate=H==2?A.rotate(n,ot,C,Ae):0;let Ye=A._size;A._size=ei(A.size(n,ot,C,g)),Ye!=null&&A._size!=Ye&&(v=!1)}),v}function Km(g){let v=!0;return ta.forEach((A,C)=>{let O=A(n,C,di,g);O!=pi[C]&&(v=!1),pi[C]=O}),v}function jm(){for(let g=0;g<w.length;g++){let v=w[g];if(!v.show||!v._show)continue;let A=v.side,C=A%2,O,H,ne=v.stroke(n,g),ae=A==0||A==3?-1:1,[de,we]=v._found;if(v.label!=null){let Tn=v.labelGap*ae,zn=sn((v._lpos+Tn)*vt);Ge(v.labelFont[0],ne,"center",A==2?"top":tf),h.save(),C==1?(O=H=0,h.translate(zn,sn(ie+Be/2)),h.rotate((A==3?-la:la)/2)):(O=sn(Ee+xe/2),H=zn);let Es=Xf(v.label)?v.label(n,g,de,we):v.label;h.fillText(Es,O,H),h.restore()}if(we==0)continue;let Ae=y[v.scale],Ue=C==0?xe:Be,je=C==0?Ee:ie,xt=v._splits,mt=Ae.distr==2?xt.map(Tn=>W[Tn]):xt,ot=Ae.distr==2?W[xt[1]]-W[xt[0]]:de,Ye=v.ticks,Ve=v.border,Nt=Ye.show?Ye.size:0,Gt=sn(Nt*vt),un=sn((v.alignTo==2?v._size-Nt-v.gap:v.gap)*vt),Et=v._rotate*-la/180,Wt=m(v._pos*vt),Bn=(Gt+un)*ae,wn=Wt+Bn;H=C==0?wn:0,O=C==1?wn:0;let Kn=v.font[0],ri=v.align==1?ur:v.align==2?Tc:Et>0?ur:Et<0?Tc:C==0?"center":A==3?Tc:ur,_i=Et||C==1?"middle":A==2?"top":tf;Ge(Kn,ne,ri,_i);let kn=v.font[1]*v.lineGap,jn=xt.map(Tn=>m(a(Tn,Ae,Ue,je))),oi=v._values;for(let Tn=0;Tn<oi.length;Tn++){let zn=oi[Tn];if(zn!=null){C==0?O=jn[Tn]:H=jn[Tn],zn=""+zn;let Es=zn.indexOf(`
`)==-1?[zn]:zn.split(/\n/gm);for(let En=0;En<Es.length;En++){let Qu=Es[En];Et?(h.save(),h.translate(O,H+En*kn),h.rotate(Et),h.fillText(Qu,0,0),h.restore()):h.fillText(Qu,O,H+En*kn)}}}Ye.show&&pc(jn,Ye.filter(n,mt,g,we,ot),C,A,Wt,Gt,It(Ye.width*vt,3),Ye.stroke(n,g),Ye.dash,Ye.cap);let xi=v.grid;xi.show&&pc(jn,xi.filter(n,mt,g,we,ot),C,C==0?2:1,C==0?ie:Ee,C==0?Be:xe,It(xi.width*vt,3),xi.stroke(n,g),xi.dash,xi.cap),Ve.show&&pc([Wt],[1],C==0?1:0,C==0?1:2,C==1?ie:Ee,C==1?Be:xe,It(Ve.width*vt,3),Ve.stroke(n,g),Ve.dash,Ve.cap)}hn("drawAxes")}function nr(g){E.forEach((v,A)=>{A>0&&(v._paths=null,g&&(s==1?(v.min=null,v.max=null):v.facets.forEach(C=>{C.min=null,C.max=null})))})}let na=!1,mc=!1,eo=[];function Qm(){mc=!1;for(let g=0;g<eo.length;g++)hn(...eo[g]);eo.length=0}function ir(){na||(jg(Fu),na=!0)}function eg(g,v=!1){na=!0,mc=v,g(n),Fu(),v&&eo.length>0&&queueMicrotask(Qm)}n.batch=eg;function Fu(){if(He&&(Mn(),He=!1),We&&(Ne(),We=!1),ve){if(Ot(d,ur,Z),Ot(d,"top",te),Ot(d,oo,x),Ot(d,ao,D),Ot(_,ur,Z),Ot(_,"top",te),Ot(_,oo,x),Ot(_,ao,D),Ot(f,oo,St),Ot(f,ao,P),u.width=sn(St*vt),u.height=sn(P*vt),w.forEach(({_el:g,_show:v,_size:A,_pos:C,side:O})=>{if(g!=null)if(v){let H=O===3||O===0?A:0,ne=O%2==1;Ot(g,ne?"left":"top",C-H),Ot(g,ne?"width":"height",A),Ot(g,ne?"top":"left",ne?te:Z),Ot(g,ne?"height":"width",ne?D:x),Uc(g,Rs)}else Vn(g,Rs)}),Me=Re=Ce=qe=ze=nt=pt=Dt=Xe=null,it=1,io(!0),Z!=ee||te!=Fe||x!=me||D!=Ie){nr(!1);let g=x/me,v=D/Ie;if(he&&!N&&pe.left>=0){pe.left*=g,pe.top*=v,sr&&vi(sr,sn(pe.left),0,x,D),rr&&vi(rr,0,sn(pe.top),x,D);for(let A=0;A<gn.length;A++){let C=gn[A];C!=null&&(Ii[A]*=g,Li[A]*=v,vi(C,ei(Ii[A]),ei(Li[A]),x,D))}}if(Ft.show&&!ye&&Ft.left>=0&&Ft.width>0){Ft.left*=g,Ft.width*=g,Ft.top*=v,Ft.height*=v;for(let A in Mc)Ot(lr,A,Ft[A])}ee=Z,Fe=te,me=x,Ie=D}hn("setSize"),ve=!1}St>0&&P>0&&(h.clearRect(0,0,u.width,u.height),hn("drawClear"),B.forEach(g=>g()),hn("draw")),Ft.show&&ye&&(ia(Ft),ye=!1),he&&N&&(Ts(null,!0,!1),N=!1),be.show&&be.live&&re&&(vc(),re=!1),l||(l=!0,n.status=1,hn("ready")),$=!1,na=!1}n.redraw=(g,v)=>{We=v||!1,g!==!1?es(I,R.min,R.max):ir()};function gc(g,v){let A=y[g];if(A.from==null){if(en==0){let C=A.range(n,v.min,v.max,g);v.min=C[0],v.max=C[1]}if(v.min>v.max){let C=v.min;v.min=v.max,v.max=C}if(en>1&&v.min!=null&&v.max!=null&&v.max-v.min<1e-16)return;g==I&&A.distr==2&&en>0&&(v.min=li(v.min,e[0]),v.max=li(v.max,e[0]),v.min==v.max&&v.max++),Y[g]=v,He=!0,ir()}}n.setScale=gc;let _c,xc,sr,rr,Nu,Ou,or,ar,Bu,ku,Ut,kt,Qi=!1,dn=pe.drag,ln=dn.x,cn=dn.y;he&&(pe.x&&(_c=Qn(bg,_)),pe.y&&(xc=Qn(Sg,_)),R.ori==0?(sr=_c,rr=xc):(sr=xc,rr=_c),Ut=pe.left,kt=pe.top);let Ft=n.select=$t({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),lr=Ft.show?Qn(Mg,Ft.over?_:d):null;function ia(g,v){if(Ft.show){for(let A in g)Ft[A]=g[A],A in Mc&&Ot(lr,A,g[A]);v!==!1&&hn("setSelect")}}n.setSelect=ia;function tg(g){if(E[g].show)Q&&Uc(Te[g],Rs);else if(Q&&Vn(Te[g],Rs),he){let A=Pn?gn[0]:gn[g];A!=null&&vi(A,-10,-10,x,D)}}function es(g,v,A){gc(g,{min:v,max:A})}function mi(g,v,A,C){v.focus!=null&&og(g),v.show!=null&&E.forEach((O,H)=>{H>0&&(g==H||g==null)&&(O.show=v.show,tg(H),s==2?(es(O.facets[0].scale,null,null),es(O.facets[1].scale,null,null)):es(O.scale,null,null),ir())}),A!==!1&&hn("setSeries",g,v),C&&so("setSeries",n,g,v)}n.setSeries=mi;function ng(g,v){$t(F[g],v)}function ig(g,v){g.fill=at(g.fill||null),g.dir=gt(g.dir,-1),v=v??F.length,F.splice(v,0,g)}function sg(g){g==null?F.length=0:F.splice(g,1)}n.addBand=ig,n.setBand=ng,n.delBand=sg;function rg(g,v){E[g].alpha=v,he&&gn[g]!=null&&(gn[g].style.opacity=v),Q&&Te[g]&&(Te[g].style.opacity=v)}let Ui,ts,ws,cr={focus:!0};function og(g){if(g!=ws){let v=g==null,A=On.alpha!=1;E.forEach((C,O)=>{if(s==1||O>0){let H=v||O==0||O==g;C._focus=v?null:H,A&&rg(O,H?1:On.alpha)}}),ws=g,A&&ir()}}Q&&Pi&&Pe(of,oe,g=>{pe._lock||(Qt(g),ws!=null&&mi(null,cr,!0,Yt.setSeries))});function gi(g,v,A){let C=y[v];A&&(g=g/vt-(C.ori==1?te:Z));let O=x;C.ori==1&&(O=D,g=O-g),C.dir==-1&&(g=O-g);let H=C._min,ne=C._max,ae=g/O,de=H+(ne-H)*ae,we=C.distr;return we==3?pr(10,de):we==4?zg(de,C.asinh):we==100?C.bwd(de):de}function ag(g,v){let A=gi(g,I,v);return li(A,e[0],qt,S)}n.valToIdx=g=>li(g,e[0]),n.posToIdx=ag,n.posToVal=gi,n.valToPos=(g,v,A)=>y[v].ori==0?r(g,y[v],A?xe:x,A?Ee:0):o(g,y[v],A?Be:D,A?ie:0),n.setCursor=(g,v,A)=>{Ut=g.left,kt=g.top,Ts(null,v,A)};function zu(g,v){Ot(lr,ur,Ft.left=g),Ot(lr,oo,Ft.width=v)}function Vu(g,v){Ot(lr,"top",Ft.top=g),Ot(lr,ao,Ft.height=v)}let to=R.ori==0?zu:Vu,no=R.ori==1?zu:Vu;function lg(){if(Q&&be.live)for(let g=s==2?1:0;g<E.length;g++){if(g==0&&Qe)continue;let v=be.values[g],A=0;for(let C in v)ut[g][A++].firstChild.nodeValue=v[C]}}function vc(g,v){if(g!=null&&(g.idxs?g.idxs.forEach((A,C)=>{ge[C]=A}):Wg(g.idx)||ge.fill(g.idx),be.idx=ge[0]),Q&&be.live){for(let A=0;A<E.length;A++)(A>0||s==1&&!Qe)&&cg(A,ge[A]);lg()}re=!1,v!==!1&&hn("setLegend")}n.setLegend=vc;function cg(g,v){let A=E[g],C=g==0&&X==2?W:e[g],O;Qe?O=A.values(n,g,v)??U:(O=A.value(n,v==null?null:C[v],g,v),O=O==null?U:{_:O}),be.values[g]=O}function Ts(g,v,A){Bu=Ut,ku=kt,[Ut,kt]=pe.move(n,Ut,kt),pe.left=Ut,pe.top=kt,he&&(sr&&vi(sr,sn(Ut),0,x,D),rr&&vi(rr,0,sn(kt),x,D));let C,O=qt>S;Ui=Pt,ts=null;let H=R.ori==0?x:D,ne=R.ori==1?x:D;if(Ut<0||en==0||O){C=pe.idx=null;for(let ae=0;ae<E.length;ae++){let de=gn[ae];de!=null&&vi(de,-10,-10,x,D)}Pi&&mi(null,cr,!0,g==null&&Yt.setSeries),be.live&&(ge.fill(C),re=!0)}else{let ae,de,we;s==1&&(ae=R.ori==0?Ut:kt,de=gi(ae,I),C=pe.idx=li(de,e[0],qt,S),we=k(e[0][C],R,H,0));let Ae=-10,Ue=-10,je=0,xt=0,mt=!0,ot="",Ye="";for(let Ve=s==2?1:0;Ve<E.length;Ve++){let Nt=E[Ve],Gt=ge[Ve],un=Gt==null?null:s==1?e[Ve][Gt]:e[Ve][1][Gt],Et=pe.dataIdx(n,Ve,C,de),Wt=Et==null?null:s==1?e[Ve][Et]:e[Ve][1][Et];if(re=re||Wt!=un||Et!=Gt,ge[Ve]=Et,Ve>0&&Nt.show){let Bn=Et==null?-10:Et==C?we:k(s==1?e[0][Et]:e[Ve][0][Et],R,H,0),wn=Wt==null?-10:G(Wt,s==1?y[Nt.scale]:y[Nt.facets[1].scale],ne,0);if(Pi&&Wt!=null){let Kn=R.ori==1?Ut:kt,ri=rn(On.dist(n,Ve,Et,wn,Kn));if(ri<Ui){let _i=On.bias;if(_i!=0){let kn=gi(Kn,Nt.scale),jn=Wt>=0?1:-1,oi=kn>=0?1:-1;oi==jn&&(oi==1?_i==1?Wt>=kn:Wt<=kn:_i==1?Wt<=kn:Wt>=kn)&&(Ui=ri,ts=Ve)}else Ui=ri,ts=Ve}}if(re||Pn){let Kn,ri;R.ori==0?(Kn=Bn,ri=wn):(Kn=wn,ri=Bn);let _i,kn,jn,oi,xi,Tn,zn=!0,Es=Lt.bbox;if(Es!=null){zn=!1;let En=Es(n,Ve);jn=En.left,oi=En.top,_i=En.width,kn=En.height}else jn=Kn,oi=ri,_i=kn=Lt.size(n,Ve);if(Tn=Lt.fill(n,Ve),xi=Lt.stroke(n,Ve),Pn)Ve==ts&&Ui<=On.prox&&(Ae=jn,Ue=oi,je=_i,xt=kn,mt=zn,ot=Tn,Ye=xi);else{let En=gn[Ve];En!=null&&(Ii[Ve]=jn,Li[Ve]=oi,df(En,_i,kn,zn),uf(En,Tn,xi),vi(En,ei(jn),ei(oi),x,D))}}}}if(Pn){let Ve=On.prox,Nt=ws==null?Ui<=Ve:Ui>Ve||ts!=ws;if(re||Nt){let Gt=gn[0];Gt!=null&&(Ii[0]=Ae,Li[0]=Ue,df(Gt,je,xt,mt),uf(Gt,ot,Ye),vi(Gt,ei(Ae),ei(Ue),x,D))}}}if(Ft.show&&Qi)if(g!=null){let[ae,de]=Yt.scales,[we,Ae]=Yt.match,[Ue,je]=g.cursor.sync.scales,xt=g.cursor.drag;if(ln=xt._x,cn=xt._y,ln||cn){let{left:mt,top:ot,width:Ye,height:Ve}=g.select,Nt=g.scales[Ue].ori,Gt=g.posToVal,un,Et,Wt,Bn,wn,Kn=ae!=null&&we(ae,Ue),ri=de!=null&&Ae(de,je);Kn&&ln?(Nt==0?(un=mt,Et=Ye):(un=ot,Et=Ve),Wt=y[ae],Bn=k(Gt(un,Ue),Wt,H,0),wn=k(Gt(un+Et,Ue),Wt,H,0),to(ci(Bn,wn),rn(wn-Bn))):to(0,H),ri&&cn?(Nt==1?(un=mt,Et=Ye):(un=ot,Et=Ve),Wt=y[de],Bn=G(Gt(un,je),Wt,ne,0),wn=G(Gt(un+Et,je),Wt,ne,0),no(ci(Bn,wn),rn(wn-Bn))):no(0,ne)}else bc()}else{let ae=rn(Bu-Nu),de=rn(ku-Ou);if(R.ori==1){let je=ae;ae=de,de=je}ln=dn.x&&ae>=dn.dist,cn=dn.y&&de>=dn.dist;let we=dn.uni;we!=null?ln&&cn&&(ln=ae>=we,cn=de>=we,!ln&&!cn&&(de>ae?cn=!0:ln=!0)):dn.x&&dn.y&&(ln||cn)&&(ln=cn=!0);let Ae,Ue;ln&&(R.ori==0?(Ae=or,Ue=Ut):(Ae=ar,Ue=kt),to(ci(Ae,Ue),rn(Ue-Ae)),cn||no(0,ne)),cn&&(R.ori==1?(Ae=or,Ue=Ut):(Ae=ar,Ue=kt),no(ci(Ae,Ue),rn(Ue-Ae)),ln||to(0,H)),!ln&&!cn&&(to(0,0),no(0,0))}if(dn._x=ln,dn._y=cn,g==null){if(A){if(ju!=null){let[ae,de]=Yt.scales;Yt.values[0]=ae!=null?gi(R.ori==0?Ut:kt,ae):null,Yt.values[1]=de!=null?gi(R.ori==1?Ut:kt,de):null}so(Ec,n,Ut,kt,x,D,C)}if(Pi){let ae=A&&Yt.setSeries,de=On.prox;ws==null?Ui<=de&&mi(ts,cr,!0,ae):Ui>de?mi(null,cr,!0,ae):ts!=ws&&mi(ts,cr,!0,ae)}}re&&(be.idx=C,vc()),v!==!1&&hn("setCursor")}let ns=null;Object.defineProperty(n,"rect",{get(){return ns==null&&io(!1),ns}});function io(g=!1){g?ns=null:(ns=_.getBoundingClientRect(),hn("syncRect",ns))}function Hu(g,v,A,C,O,H,ne){pe._lock||Qi&&g!=null&&g.movementX==0&&g.movementY==0||(yc(g,v,A,C,O,H,ne,!1,g!=null),g!=null?Ts(null,!0,!0):Ts(v,!0,!1))}function yc(g,v,A,C,O,H,ne,ae,de){if(ns==null&&io(!1),Qt(g),g!=null)A=g.clientX-ns.left,C=g.clientY-ns.top;else{if(A<0||C<0){Ut=-10,kt=-10;return}let[we,Ae]=Yt.scales,Ue=v.cursor.sync,[je,xt]=Ue.values,[mt,ot]=Ue.scales,[Ye,Ve]=Yt.match,Nt=v.axes[0].side%2==1,Gt=R.ori==0?x:D,un=R.ori==1?x:D,Et=Nt?H:O,Wt=Nt?O:H,Bn=Nt?C:A,wn=Nt?A:C;if(mt!=null?A=Ye(we,mt)?a(je,y[we],Gt,0):-10:A=Gt*(Bn/Et),ot!=null?C=Ve(Ae,ot)?a(xt,y[Ae],un,0):-10:C=un*(wn/Wt),R.ori==1){let Kn=A;A=C,C=Kn}}de&&(v==null||v.cursor.event.type==Ec)&&((A<=1||A>=x-1)&&(A=As(A,x)),(C<=1||C>=D-1)&&(C=As(C,D))),ae?(Nu=A,Ou=C,[or,ar]=pe.move(n,A,C)):(Ut=A,kt=C)}let Mc={width:0,height:0,left:0,top:0};function bc(){ia(Mc,!1)}let Gu,Wu,Xu,qu;function Yu(g,v,A,C,O,H,ne){Qi=!0,ln=cn=dn._x=dn._y=!1,yc(g,v,A,C,O,H,ne,!0,!1),g!=null&&(Pe(Ac,Lc,$u,!1),so(sf,n,or,ar,x,D,null));let{left:ae,top:de,width:we,height:Ae}=Ft;Gu=ae,Wu=de,Xu=we,qu=Ae}function $u(g,v,A,C,O,H,ne){Qi=dn._x=dn._y=!1,yc(g,v,A,C,O,H,ne,!1,!0);let{left:ae,top:de,width:we,height:Ae}=Ft,Ue=we>0||Ae>0,je=Gu!=ae||Wu!=de||Xu!=we||qu!=Ae;if(Ue&&je&&ia(Ft),dn.setScale&&Ue&&je){let xt=ae,mt=we,ot=de,Ye=Ae;if(R.ori==1&&(xt=de,mt=Ae,ot=ae,Ye=we),ln&&es(I,gi(xt,I),gi(xt+mt,I)),cn)for(let Ve in y){let Nt=y[Ve];Ve!=I&&Nt.from==null&&Nt.min!=Pt&&es(Ve,gi(ot+Ye,Ve),gi(ot,Ve))}bc()}else pe.lock&&(pe._lock=!pe._lock,Ts(v,!0,g!=null));g!=null&&($e(Ac,Lc),so(Ac,n,Ut,kt,x,D,null))}function hg(g,v,A,C,O,H,ne){if(pe._lock)return;Qt(g);let ae=Qi;if(Qi){let de=!0,we=!0,Ae=10,Ue,je;R.ori==0?(Ue=ln,je=cn):(Ue=cn,je=ln),Ue&&je&&(de=Ut<=Ae||Ut>=x-Ae,we=kt<=Ae||kt>=D-Ae),Ue&&de&&(Ut=Ut<or?0:x),je&&we&&(kt=kt<ar?0:D),Ts(null,!0,!0),Qi=!1}Ut=-10,kt=-10,ge.fill(null),Ts(null,!0,!0),ae&&(Qi=ae)}function Zu(g,v,A,C,O,H,ne){pe._lock||(Qt(g),fe(),bc(),g!=null&&so(af,n,Ut,kt,x,D,null))}function Ju(){w.forEach(o_),Le(n.width,n.height,!0)}Ps(ca,dr,Ju);let hr={};hr.mousedown=Yu,hr.mousemove=Hu,hr.mouseup=$u,hr.dblclick=Zu,hr.setSeries=(g,v,A,C)=>{let O=Yt.match[2];A=O(n,v,A),A!=-1&&mi(A,C,!0,!1)},he&&(Pe(sf,_,Yu),Pe(Ec,_,Hu),Pe(rf,_,g=>{Qt(g),io(!1)}),Pe(of,_,hg),Pe(af,_,Zu),zc.add(n),n.syncRect=io);let sa=n.hooks=i.hooks||{};function hn(g,v,A){mc?eo.push([g,v,A]):g in sa&&sa[g].forEach(C=>{C.call(null,n,v,A)})}(i.plugins||[]).forEach(g=>{for(let v in g.hooks)sa[v]=(sa[v]||[]).concat(g.hooks[v])});let Ku=(g,v,A)=>A,Yt=$t({key:null,setSeries:!1,filters:{pub:xf,sub:xf},scales:[I,E[1]?E[1].scale:null],match:[vf,vf,Ku],values:[null,null]},pe.sync);Yt.match.length==2&&Yt.match.push(Ku),pe.sync=Yt;let ju=Yt.key,Sc=md(ju);function so(g,v,A,C,O,H,ne){Yt.filters.pub(g,v,A,C,O,H,ne)&&Sc.pub(g,v,A,C,O,H,ne)}Sc.sub(n);function ug(g,v,A,C,O,H,ne){Yt.filters.sub(g,v,A,C,O,H,ne)&&hr[g](null,v,A,C,O,H,ne)}n.pub=ug;function fg(){Sc.unsub(n),zc.delete(n),tt.clear(),Fc(ca,dr,Ju),c.remove(),oe?.remove(),hn("destroy")}n.destroy=fg;function wc(){hn("init",i,e),V(e||i.data,!1),Y[I]?gc(I,Y[I]):fe(),ye=Ft.show&&(Ft.width>0||Ft.height>0),N=re=!0,Le(i.width,i.height)}return E.forEach(Qr),w.forEach(dc),t?t instanceof HTMLElement?(t.appendChild(c),wc()):t(n,wc):wc(),n}pn.assign=$t;pn.fmtNum=Yc;pn.rangeNum=ha;pn.rangeLog=da;pn.rangeAsinh=Xc;pn.orient=Ls;pn.pxRatio=vt;pn.join=Kg;pn.fmtDate=Zc,pn.tzDate=l0;pn.sync=md;{pn.addGap=W0,pn.clipGaps=ga;let i=pn.paths={points:Md};i.linear=Sd,i.stepped=Y0,i.bars=$0,i.spline=J0}var a_=["440154","482878","3e4a89","31688e","26828e","1f9e89","35b779","6ece58","b5de2b","fde725"],l_=["053061","2166ac","4393c3","92c5de","d1e5f0","f7f7f7","fddbc7","f4a582","d6604d","b2182b","67001f"],c_=["88ccee","ddcc77","44aa99","cc6677","999933","aa4499","117733","6699cc","ee99aa","997700"],nh=i=>[0,2,4].map(e=>parseInt(i.slice(e,e+2),16)),h_={magnitude:a_.map(nh),signed:l_.map(nh)},Ad=c_.map(nh);function fo(i,e){let t=h_[i],n=Math.min(1,Math.max(0,e))*(t.length-1),s=Math.min(t.length-2,Math.floor(n));return[0,1,2].map(r=>Math.round(t[s][r]+(n-s)*(t[s+1][r]-t[s][r])))}function ih(i){let e=new Uint8Array(1024);for(let t=0;t<256;++t)e.set([...fo(i,t/255),255],4*t);return e}var Mr=i=>Ad[i%Ad.length],rs=i=>`rgb(${i[0]}, ${i[1]}, ${i[2]})`;function Cd(i,e){let t=["#0072b2","#c0392b","#007a5e","#8e44ad","#a86500","#2c3e50","#b8327a","#4d6b00","#0099a8","#7a5230"];return(e?["#56b4e9","#ff8a75","#3fd6a8","#d09bf0","#f5b942","#c9d4dd","#ff8fc7","#b5d65a","#5ee0ec","#d9ad80"]:t)[i%t.length]}var u_=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"\xB5"]];function Ds(i,e){if(i==="")return{factor:1,name:""};let t=i==="m"||i==="m/s"||i==="s";for(let[n,s]of u_)if(!(t&&n>1)&&e>=n*(n===1&&t?.1:1))return{factor:n,name:s+i};return e>0?{factor:1e-6,name:"\xB5"+i}:{factor:1,name:i}}function Xt(i,e=3){if(!Number.isFinite(i))return"\u2013";if(i===0)return"0";let t=Math.abs(i);if(t>=1e6||t<1e-4){let[s,r]=i.toExponential(e-1).split("e");return`${Rd(s)}\xB710${sh(Number(r))}`}let n=Math.max(0,e-1-Math.floor(Math.log10(t)));return Rd(i.toFixed(Math.min(n,8)))}function mn(i,e,t=3){let n=Ds(e,Math.abs(i));return n.name?`${Xt(i/n.factor,t)} ${n.name}`:Xt(i,t)}function Wn(i){return`${i.toFixed(3)} s`}function Rd(i){return i.replace("-","\u2212")}function sh(i){let e="\u2070\xB9\xB2\xB3\u2074\u2075\u2076\u2077\u2078\u2079";return String(i).split("").map(t=>t==="-"?"\u207B":e[Number(t)]).join("")}function Pd(i){let e=10**Math.floor(Math.log10(i));for(let t of[5,2])if(t*e<=i)return t*e;return e}var Id=matchMedia("(prefers-color-scheme: dark)"),rh=i=>getComputedStyle(document.documentElement).getPropertyValue(i).trim(),ya=class{constructor(e,t,n,s){this.element=e;this.height=t;this.stages=n;this.on_time=s;this.plot=null;this.mark=null;this.time=0;this.remake=null;Id.addEventListener("change",()=>this.remake?.()),new ResizeObserver(()=>this.plot?.setSize({width:this.width(),height:this.height})).observe(e)}width(){return Math.max(200,this.element.clientWidth)}draw(e,t,n){this.remake=()=>this.make(e,t,n),this.make(e,t,n)}make(e,t,n){this.plot?.destroy(),this.element.replaceChildren();let s=0;for(let f of n)for(let d=0;d<f.values.length;++d)Number.isFinite(f.values[d])&&(s=Math.max(s,Math.abs(f.values[d])));let r=e.log?{factor:1,name:e.unit}:Ds(e.unit,s),o=f=>Array.from(f,d=>!Number.isFinite(d)||e.log&&!(d>0)?null:d/r.factor),a=rh("--ink"),l={stroke:rh("--line"),width:1},c={stroke:a,grid:l,ticks:l,font:"11px system-ui, sans-serif",labelFont:"12px system-ui, sans-serif",labelSize:20},u=`${e.what}${r.name?` [${r.name}]`:""}`,h={width:this.width(),height:this.height,scales:{x:{time:!1},y:e.log?{distr:3}:{}},axes:[{...c,label:"time [s]"},{...c,label:u,size:58,values:(f,d)=>d.map(_=>_===null?"":e.log?`10${sh(Math.round(Math.log10(_)))}`:d_(_)),...e.log?{splits:(f,d,_,M)=>f_(_,M),filter:(f,d)=>d}:{}}],series:[{label:"time",value:(f,d)=>d==null?"\u2013":`${d.toFixed(3)} s`},...n.map((f,d)=>({label:f.label,stroke:Cd(d,Id.matches),width:1.5,points:{show:!1},...f.dash?{dash:f.dash}:{},value:(_,M)=>M==null?"\u2013":`${Xt(M)}${r.name?` ${r.name}`:""}`}))],cursor:{drag:{x:!0,y:!1},points:{size:6}},hooks:{drawClear:[f=>this.draw_stages(f)],ready:[f=>{this.mark=document.createElement("div"),this.mark.className="now",f.over.append(this.mark),f.over.addEventListener("mouseleave",()=>setTimeout(()=>this.at(this.time))),f.over.addEventListener("click",d=>this.on_time(f.posToVal(d.offsetX,"x")))}],setSize:[()=>this.at(this.time)],setScale:[()=>this.at(this.time)]}};this.plot=new pn(h,[Array.from(t),...n.map(f=>o(f.values))],this.element),this.at(this.time)}draw_stages(e){let t=e.ctx;t.save(),t.strokeStyle=t.fillStyle=rh("--quiet"),t.font=`${Math.round(10*devicePixelRatio)}px system-ui, sans-serif`,t.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);let n=-1/0;for(let s of this.stages){if(s.start===null)continue;let r=e.valToPos(s.start,"x",!0);r<e.bbox.left-1||r>e.bbox.left+e.bbox.width||(r>e.bbox.left+1&&(t.beginPath(),t.moveTo(r,e.bbox.top),t.lineTo(r,e.bbox.top+e.bbox.height),t.stroke()),!(r<n)&&(t.fillText(s.name,r+3,e.bbox.top-3),n=r+6+t.measureText(s.name).width))}t.restore()}at(e){if(this.time=e,!this.plot||!this.mark)return;let t=this.plot.valToPos(e,"x");this.mark.style.transform=`translateX(${Math.round(t)}px)`,this.mark.hidden=!(t>=0&&t<=this.plot.over.clientWidth),this.plot.over.matches(":hover")||this.plot.setLegend({idx:this.plot.posToIdx(t)})}};function f_(i,e){let[t,n]=[Math.ceil(Math.log10(i)-1e-9),Math.floor(Math.log10(e)+1e-9)],s=Math.max(1,Math.ceil((n-t+1)/7)),r=[];for(let o=t;o<=n;o+=s)r.push(10**o);return r}function d_(i){return Math.abs(i)>=1e5?i.toExponential(1):String(Number(i.toPrecision(6))).replace("-","\u2212")}function Ld(i,e,t){let n=a=>a.reduce((l,c)=>Number.isFinite(c)?Math.max(l,Math.abs(c)):l,0),s=i.history.ledger.map((a,l)=>({...a,values:e.get(`l.${l}`)??new Float32Array(0)})),r=Math.max(0,...s.filter(a=>t.includes(a.side)).map(a=>n(a.values))),o={work:[6,3],dissipated:[8,3,2,3],scheme:[2,3]};return t.flatMap(a=>s.filter(l=>l.side===a&&n(l.values)>.001*r).map(l=>({label:`${l.name.replaceAll("_"," ")} (${a==="dissipated"?"dissipation":a})`,values:l.values,dash:o[a]})))}function Dd(i){let e=i.get("l.closure")??new Float32Array(0),t=i.get("l.moved")??new Float32Array(0);return e.map((n,s)=>t[s]>0?Math.abs(n)/t[s]:0)}var oh=["displacement","horizontal displacement","vertical displacement","speed","principal stress \u03C3\u2081","principal stress \u03C3\u2083"];function Ud(i,e,t){let n=a=>{let l=e.get(`${a}u`)??new Float32Array(0),c=e.get(`${a}v`)??new Float32Array(0),u=e.get(`${a}s`)??new Float32Array(0),h=(d,_)=>Float32Array.from({length:d},(M,m)=>_(m)),f=(d,_)=>.5*(u[3*d]+u[3*d+1])+_*Math.hypot(.5*(u[3*d]-u[3*d+1]),u[3*d+2]);return t==="displacement"?h(l.length/2,d=>Math.hypot(l[2*d],l[2*d+1])):t==="horizontal displacement"?h(l.length/2,d=>l[2*d]):t==="vertical displacement"?h(l.length/2,d=>l[2*d+1]):t==="speed"?h(c.length/2,d=>Math.hypot(c[2*d],c[2*d+1])):h(u.length/3,d=>f(d,t.endsWith("\u03C3\u2081")?1:-1))},s=t.includes("stress")?"Pa":t==="speed"?"m/s":"m",r=e.get("m0.time")??new Float32Array(0),o=i.history.monitors.map((a,l)=>({label:a.name,values:n(`m${l}.`)}));return{time:r,series:o,unit:s}}var Fd=(i,e)=>.5*(i.stress[3*e]+i.stress[3*e+1]),ah=(i,e)=>Math.hypot(.5*(i.stress[3*e]-i.stress[3*e+1]),i.stress[3*e+2]),Us=[{id:"displacement",label:"displacement",unit:"m",kind:"magnitude",point:(i,e)=>Math.hypot(i.displacement[2*e],i.displacement[2*e+1])},{id:"ux",label:"horizontal displacement",unit:"m",kind:"signed",point:(i,e)=>i.displacement[2*e]},{id:"uy",label:"vertical displacement",unit:"m",kind:"signed",point:(i,e)=>i.displacement[2*e+1]},{id:"speed",label:"speed",unit:"m/s",kind:"magnitude",point:(i,e)=>Math.hypot(i.velocity[2*e],i.velocity[2*e+1])},{id:"s1",label:"principal stress \u03C3\u2081 (larger)",unit:"Pa",kind:"signed",point:(i,e)=>Fd(i,e)+ah(i,e)},{id:"s3",label:"principal stress \u03C3\u2083 (smaller)",unit:"Pa",kind:"signed",point:(i,e)=>Fd(i,e)-ah(i,e)},{id:"shear",label:"maximum shear stress",unit:"Pa",kind:"magnitude",point:ah},{id:"sxx",label:"stress \u03C3xx",unit:"Pa",kind:"signed",point:(i,e)=>i.stress[3*e]},{id:"syy",label:"stress \u03C3yy",unit:"Pa",kind:"signed",point:(i,e)=>i.stress[3*e+1]},{id:"sxy",label:"shear stress \u03C3xy",unit:"Pa",kind:"signed",point:(i,e)=>i.stress[3*e+2]},{id:"method",label:"method",unit:"",kind:"names",cell:(i,e,t)=>i.method[t],names:i=>i.model.methods.map(e=>e.toUpperCase())},{id:"integrator",label:"time integrator",unit:"",kind:"names",cell:(i,e,t)=>e.integrator[t],names:()=>["explicit","implicit"]},{id:"material",label:"material",unit:"",kind:"names",cell:(i,e,t)=>i.material[t],names:i=>i.model.materials.map(e=>e.name)},{id:"block",label:"block",unit:"",kind:"names",cell:(i,e,t)=>i.block[t]}];function Nd(i){let e=i==="speed"?{id:"scalar",label:"mean speed",unit:"m/s",kind:"magnitude",cell:(t,n,s)=>n.scalar[s]}:{id:"scalar",label:i,unit:"Pa",kind:"signed",cell:(t,n,s)=>n.scalar[s]};return[...Us.filter(t=>["displacement","ux","uy"].includes(t.id)),e,...Us.filter(t=>["method","material","block"].includes(t.id))]}function Od(i,e,t,n){let s=i.point?new Float32Array(e.origin.length/2):null;if(s)for(let r=0;r<s.length;++r)s[r]=i.point(t,r);for(let r=0;r+1<e.offsets.length;++r){let o=i.cell?i.cell(e,t,r):0;for(let a=e.offsets[r];a<e.offsets[r+1];++a)n[a]=s?s[e.cells[a]]:o}}function Bd(i,e,t,n){let s=[];for(let l=0;l+1<e.offsets.length;++l)if(!n(e.block[l]))for(let c=e.offsets[l];c<e.offsets[l+1];++c)Number.isFinite(t[c])&&s.push(Math.abs(t[c]));s.sort((l,c)=>l-c);let r=i.unit==="Pa"?.99:1,o=s.length>0?s[Math.min(s.length-1,Math.floor(r*s.length))]:0,a=o>0?o:1;return[i.kind==="signed"?-a:0,a]}function hh(i,e,t=2){let n=e&&e.length,s=n?e[0]*t:i.length,r=zd(i,0,s,t,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=x_(i,e,r,t)),i.length>80*t){a=i[0],l=i[1];let u=a,h=l;for(let f=t;f<s;f+=t){let d=i[f],_=i[f+1];d<a&&(a=d),_<l&&(l=_),d>u&&(u=d),_>h&&(h=_)}c=Math.max(u-a,h-l),c=c!==0?32767/c:0}return mo(r,o,t,a,l,c,0),o}function zd(i,e,t,n,s){let r;if(s===R_(i,e,t,n)>0)for(let o=e;o<t;o+=n)r=kd(o/n|0,i[o],i[o+1],r);else for(let o=t-n;o>=e;o-=n)r=kd(o/n|0,i[o],i[o+1],r);return r&&br(r,r.next)&&(_o(r),r=r.next),r}function Fs(i,e){if(!i)return i;e||(e=i);let t=i,n;do if(n=!1,!t.steiner&&(br(t,t.next)||Vt(t.prev,t,t.next)===0)){if(_o(t),t=e=t.prev,t===t.next)break;n=!0}else t=t.next;while(n||t!==e);return e}function mo(i,e,t,n,s,r,o){if(!i)return;!o&&r&&S_(i,n,s,r);let a=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?m_(i,n,s,r):p_(i)){e.push(l.i,i.i,c.i),_o(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=g_(Fs(i),e),mo(i,e,t,n,s,r,2)):o===2&&__(i,e,t,n,s,r):mo(Fs(i),e,t,n,s,r,1);break}}}function p_(i){let e=i.prev,t=i,n=i.next;if(Vt(e,t,n)>=0)return!1;let s=e.x,r=t.x,o=n.x,a=e.y,l=t.y,c=n.y,u=Math.min(s,r,o),h=Math.min(a,l,c),f=Math.max(s,r,o),d=Math.max(a,l,c),_=n.next;for(;_!==e;){if(_.x>=u&&_.x<=f&&_.y>=h&&_.y<=d&&po(s,a,r,l,o,c,_.x,_.y)&&Vt(_.prev,_,_.next)>=0)return!1;_=_.next}return!0}function m_(i,e,t,n){let s=i.prev,r=i,o=i.next;if(Vt(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,u=s.y,h=r.y,f=o.y,d=Math.min(a,l,c),_=Math.min(u,h,f),M=Math.max(a,l,c),m=Math.max(u,h,f),p=lh(d,_,e,t,n),E=lh(M,m,e,t,n),w=i.prevZ,y=i.nextZ;for(;w&&w.z>=p&&y&&y.z<=E;){if(w.x>=d&&w.x<=M&&w.y>=_&&w.y<=m&&w!==s&&w!==o&&po(a,u,l,h,c,f,w.x,w.y)&&Vt(w.prev,w,w.next)>=0||(w=w.prevZ,y.x>=d&&y.x<=M&&y.y>=_&&y.y<=m&&y!==s&&y!==o&&po(a,u,l,h,c,f,y.x,y.y)&&Vt(y.prev,y,y.next)>=0))return!1;y=y.nextZ}for(;w&&w.z>=p;){if(w.x>=d&&w.x<=M&&w.y>=_&&w.y<=m&&w!==s&&w!==o&&po(a,u,l,h,c,f,w.x,w.y)&&Vt(w.prev,w,w.next)>=0)return!1;w=w.prevZ}for(;y&&y.z<=E;){if(y.x>=d&&y.x<=M&&y.y>=_&&y.y<=m&&y!==s&&y!==o&&po(a,u,l,h,c,f,y.x,y.y)&&Vt(y.prev,y,y.next)>=0)return!1;y=y.nextZ}return!0}function g_(i,e){let t=i;do{let n=t.prev,s=t.next.next;!br(n,s)&&Hd(n,t,t.next,s)&&go(n,s)&&go(s,n)&&(e.push(n.i,t.i,s.i),_o(t),_o(t.next),t=i=s),t=t.next}while(t!==i);return Fs(t)}function __(i,e,t,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&E_(o,a)){let l=Gd(o,a);o=Fs(o,o.next),l=Fs(l,l.next),mo(o,e,t,n,s,r,0),mo(l,e,t,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function x_(i,e,t,n){let s=[];for(let r=0,o=e.length;r<o;r++){let a=e[r]*n,l=r<o-1?e[r+1]*n:i.length,c=zd(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(T_(c))}s.sort(v_);for(let r=0;r<s.length;r++)t=y_(s[r],t);return t}function v_(i,e){let t=i.x-e.x;if(t===0&&(t=i.y-e.y,t===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(e.next.y-e.y)/(e.next.x-e.x);t=n-s}return t}function y_(i,e){let t=M_(i,e);if(!t)return e;let n=Gd(t,i);return Fs(n,n.next),Fs(t,t.next)}function M_(i,e){let t=e,n=i.x,s=i.y,r=-1/0,o;if(br(i,t))return t;do{if(br(i,t.next))return t.next;if(s<=t.y&&s>=t.next.y&&t.next.y!==t.y){let h=t.x+(s-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(h<=n&&h>r&&(r=h,o=t.x<t.next.x?t:t.next,h===n))return o}t=t.next}while(t!==e);if(!o)return null;let a=o,l=o.x,c=o.y,u=1/0;t=o;do{if(n>=t.x&&t.x>=l&&n!==t.x&&Vd(s<c?n:r,s,l,c,s<c?r:n,s,t.x,t.y)){let h=Math.abs(s-t.y)/(n-t.x);go(t,i)&&(h<u||h===u&&(t.x>o.x||t.x===o.x&&b_(o,t)))&&(o=t,u=h)}t=t.next}while(t!==a);return o}function b_(i,e){return Vt(i.prev,i,e.prev)<0&&Vt(e.next,i,i.next)<0}function S_(i,e,t,n){let s=i;do s.z===0&&(s.z=lh(s.x,s.y,e,t,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,w_(s)}function w_(i){let e,t=1;do{let n=i,s;i=null;let r=null;for(e=0;n;){e++;let o=n,a=0;for(let c=0;c<t&&(a++,o=o.nextZ,!!o);c++);let l=t;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,t*=2}while(e>1);return i}function lh(i,e,t,n,s){return i=(i-t)*s|0,e=(e-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,i|e<<1}function T_(i){let e=i,t=i;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==i);return t}function Vd(i,e,t,n,s,r,o,a){return(s-o)*(e-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(t-o)*(e-a)&&(t-o)*(r-a)>=(s-o)*(n-a)}function po(i,e,t,n,s,r,o,a){return!(i===o&&e===a)&&Vd(i,e,t,n,s,r,o,a)}function E_(i,e){return i.next.i!==e.i&&i.prev.i!==e.i&&!A_(i,e)&&(go(i,e)&&go(e,i)&&C_(i,e)&&(Vt(i.prev,i,e.prev)||Vt(i,e.prev,e))||br(i,e)&&Vt(i.prev,i,i.next)>0&&Vt(e.prev,e,e.next)>0)}function Vt(i,e,t){return(e.y-i.y)*(t.x-e.x)-(e.x-i.x)*(t.y-e.y)}function br(i,e){return i.x===e.x&&i.y===e.y}function Hd(i,e,t,n){let s=ba(Vt(i,e,t)),r=ba(Vt(i,e,n)),o=ba(Vt(t,n,i)),a=ba(Vt(t,n,e));return!!(s!==r&&o!==a||s===0&&Ma(i,t,e)||r===0&&Ma(i,n,e)||o===0&&Ma(t,i,n)||a===0&&Ma(t,e,n))}function Ma(i,e,t){return e.x<=Math.max(i.x,t.x)&&e.x>=Math.min(i.x,t.x)&&e.y<=Math.max(i.y,t.y)&&e.y>=Math.min(i.y,t.y)}function ba(i){return i>0?1:i<0?-1:0}function A_(i,e){let t=i;do{if(t.i!==i.i&&t.next.i!==i.i&&t.i!==e.i&&t.next.i!==e.i&&Hd(t,t.next,i,e))return!0;t=t.next}while(t!==i);return!1}function go(i,e){return Vt(i.prev,i,i.next)<0?Vt(i,e,i.next)>=0&&Vt(i,i.prev,e)>=0:Vt(i,e,i.prev)<0||Vt(i,i.next,e)<0}function C_(i,e){let t=i,n=!1,s=(i.x+e.x)/2,r=(i.y+e.y)/2;do t.y>r!=t.next.y>r&&t.next.y!==t.y&&s<(t.next.x-t.x)*(r-t.y)/(t.next.y-t.y)+t.x&&(n=!n),t=t.next;while(t!==i);return n}function Gd(i,e){let t=ch(i.i,i.x,i.y),n=ch(e.i,e.x,e.y),s=i.next,r=e.prev;return i.next=e,e.prev=i,t.next=s,s.prev=t,n.next=t,t.prev=n,r.next=n,n.prev=r,n}function kd(i,e,t,n){let s=ch(i,e,t);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function _o(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function ch(i,e,t){return{i,x:e,y:t,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function R_(i,e,t,n){let s=0;for(let r=e,o=t-n;r<t;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}function Wd(i){let e=[];for(let t=0;t+1<i.offsets.length;++t){let n=i.offsets[t],s=i.offsets[t+1]-n;if(s===3){e.push(n,n+1,n+2);continue}let r=[];for(let o=0;o<s;++o){let a=i.cells[n+o];r.push(i.origin[2*a],i.origin[2*a+1])}for(let o of hh(r))e.push(n+o)}return new Uint32Array(e)}function Xd(i){let e=0;for(let a of i.origin)e=Math.max(e,Math.abs(a));let t=Math.max(1e-6*e,1e-30),n=new Map,s=(a,l)=>{let c=`${a} ${Math.round(i.origin[2*l]/t)} ${Math.round(i.origin[2*l+1]/t)}`,u=n.get(c);return u===void 0&&n.set(c,u=n.size),u},r=new Map;for(let a=0;a+1<i.offsets.length;++a){let l=i.offsets[a],c=i.offsets[a+1];for(let u=l;u<c;++u){let h=i.cells[u],f=i.cells[u+1<c?u+1:l],d=s(i.block[a],h),_=s(i.block[a],f),M=d<_?`${d} ${_}`:`${_} ${d}`,m=r.get(M);m?m.count+=1:r.set(M,{a:h,b:f,block:i.block[a],count:1})}}let o=[...r.values()].filter(a=>a.count===1);return{edges:new Uint32Array(o.flatMap(a=>[a.a,a.b])),block:new Int32Array(o.map(a=>a.block))}}function qd(i,e,t,n){for(let s=0;s+1<i.offsets.length;++s){let r=i.offsets[s],o=i.offsets[s+1],a=!1;for(let l=r,c=o-1;l<o;c=l++){let u=2*i.cells[l],h=2*i.cells[c],f=e[u+1],d=e[h+1];f>n!=d>n&&t<e[u]+(n-f)/(d-f)*(e[h]-e[u])&&(a=!a)}if(a)return s}return-1}function Yd(i){let e=new Float64Array(i.offsets.length-1);for(let t=0;t<e.length;++t){let n=i.offsets[t],s=i.offsets[t+1],r=0;for(let o=n,a=s-1;o<s;a=o++){let l=2*i.cells[o],c=2*i.cells[a];r+=i.origin[c]*i.origin[l+1]-i.origin[l]*i.origin[c+1]}e[t]=Math.abs(.5*r)}return e}var os=class{constructor(){this.ends=[];this.tint=[]}add(e,t,n,s,r){this.ends.push(e,t,n,s),this.tint.push(...r)}done(){return{ends:new Float32Array(this.ends),tint:new Uint8Array(this.tint)}}},uh=[24,82,160],fh=[200,30,30],dh=[0,114,178],ph=[213,94,0],mh=[170,20,110];function $d(i){let e=i.filter(Number.isFinite).sort((t,n)=>t-n);return e.length>0?e[Math.min(e.length-1,Math.floor(.98*e.length))]:0}function Zd(i,e,t,n,s){let r=new Set,o=[];for(let h=0;h+1<i.offsets.length;++h){if(n(i.block[h]))continue;let f=i.offsets[h],d=i.offsets[h+1],_={x:0,y:0,xx:0,yy:0,xy:0};for(let m=f;m<d;++m){let p=i.cells[m];_.x+=t[2*p]/(d-f),_.y+=t[2*p+1]/(d-f),_.xx+=e.stress[3*p]/(d-f),_.yy+=e.stress[3*p+1]/(d-f),_.xy+=e.stress[3*p+2]/(d-f)}let M=`${Math.floor(_.x/s)} ${Math.floor(_.y/s)}`;r.has(M)||(r.add(M),o.push(_))}let a=o.map(h=>{let f=.5*(h.xx+h.yy),d=Math.hypot(.5*(h.xx-h.yy),h.xy),_=.5*Math.atan2(2*h.xy,h.xx-h.yy);return{...h,s1:f+d,s3:f-d,angle:_}}),l=$d(a.map(h=>Math.max(Math.abs(h.s1),Math.abs(h.s3)))),c=.55*s,u=new os;if(l>0)for(let h of a)for(let[f,d]of[[h.s1,h.angle],[h.s3,h.angle+.5*Math.PI]]){let _=c*Math.min(1.5,Math.abs(f)/l),M=_*Math.cos(d),m=_*Math.sin(d);u.add(h.x-M,h.y-m,h.x+M,h.y+m,f>0?fh:uh)}return{...u.done(),stress:l,arm:c}}function Jd(i,e){let t=i.state.length,n=a=>Math.hypot(i.force[2*a],i.force[2*a+1]),s=$d(Array.from({length:t},(a,l)=>n(l))),r={force:s,length:e,sticking:0,slipping:0,failed:0},o=new os;for(let a=0;a<t;++a){let l=i.state[a];(l&3)===2?r.sticking+=1:r.slipping+=1,l&4&&(r.failed+=1);let[c,u]=[i.normal[2*a],i.normal[2*a+1]],[h,f]=[i.force[2*a],i.force[2*a+1]],d=s>0?.5*e/Math.max(s,n(a)):0,[_,M]=[d*(h*c-f*u),d*(h*u+f*c)],[m,p]=[i.position[2*a],i.position[2*a+1]];o.add(m-_,p-M,m+_,p+M,(l&3)===2?dh:l&4?mh:ph)}return{...o.done(),...r}}function Kd(i,e){let t=new os;for(let n of i.model.blocks)for(let s of n.rings)for(let r=0;r<s.length;r+=2){let o=(r+2)%s.length;t.add(s[r],s[r+1],s[o],s[o+1],e)}return t.done()}function jd(i,e,t){let n=new os;for(let[s,r,o,a]of i.model.supports){let l=(h,f)=>a?[s+f*t,r-h*t]:[s-h*t,r+f*t],c=(h,f,d,_)=>n.add(...l(h,f),...l(d,_),e),u=o&&a?1:1.25;c(0,0,1,-.6),c(0,0,1,.6),c(1,-.6,1,.6),c(u,-.8,u,.8);for(let h of[-.6,-.2,.2,.6])c(u,h,u+.3,h-.25)}return n.done()}function Qd(i,e,t){let n=new os;for(let[s,r]of i)for(let[o,a,l,c]of[[1,0,0,1],[0,1,-1,0],[-1,0,0,-1],[0,-1,1,0]])n.add(s+o*t,r+a*t,s+l*t,r+c*t,e);return n.done()}function ep(i){let e=new os,t=n=>n.forEach(([s,r,o,a,l])=>e.add(s,r,o,a,Mr(l+3)));return t(i.model.joints.lines),t(i.model.joints.cracks),e.done()}function Ze(i,e,t){let n=document.createElement(i);return e!==void 0&&(n.textContent=e),t&&(n.className=t),n}function Sa(i,e){let t=Ze("dl");for(let[n,s]of e)s===void 0||s===""||t.append(Ze("dt",n),Ze("dd",s));i.replaceChildren(t)}function xo(i,e,t){let n=Ze("table");n.append(Ze("caption",t));let s=Ze("tr");for(let a of i){let l=Ze("th",a);l.scope="col",s.append(l)}let r=Ze("thead");r.append(s);let o=Ze("tbody");for(let a of e){let l=Ze("tr");for(let c of a)l.append(Ze("td",c));o.append(l)}return n.append(r,o),n}var Zt=(i,e)=>typeof i?.[e]=="number"?i[e]:void 0,Xn=(i,e)=>typeof i?.[e]=="string"?i[e]:void 0,vo=(i,e)=>i&&typeof i[e]=="object"?i[e]:null,Oi=i=>i?.toLocaleString("en").replaceAll(","," "),P_={done:"done",interrupted:"interrupted",not_converged:"did not converge",non_finite:"ended with numbers that are not finite"};function gh(i){let e=Xn(i.found,"status")??String(i.asked.status??"");return P_[e]??(e||"has not ended")}function tp(i,e){let t=i.asked,n=[["Run",i.folder],["Command line",Xn(t,"command_line")],["Settings changed",i.asked.set.join(", ")],["Scree",[Xn(t,"version"),Xn(t,"commit")].filter(Boolean).join(", commit ")],["Built with",[Xn(t,"compiler"),Xn(t,"instruction_set")].filter(Boolean).join(", ")],["Libraries",i.asked.libraries.map(([o,a])=>`${o} ${a}`).join(", ")],["Threads",Oi(Zt(i.found,"threads"))],["Resumed at",Xn(t,"resumed")],["SHA-256 of the case",Xn(t,"case_sha256")]];Sa(e,n),e.append(xo(["Stage","Time integration","Start","Planned"],i.stages.map(o=>[o.name,o.integrator,o.start===null?"not reached":Wn(o.start),Wn(o.duration)]),"Stages"),xo(["Material","Density","Young's modulus","Poisson's ratio"],i.model.materials.map(o=>[o.name,`${Xt(o.density,4)} kg/m\xB3`,mn(o.young,"Pa"),Xt(o.poisson)]),"Materials"),xo(["Joint","Friction","Cohesion","Tensile strength"],i.model.joints.laws.map(o=>[o.name,`${Xt(o.friction_deg)}\xB0`,mn(o.cohesion,"Pa"),o.tensile_strength===null?"unlimited":mn(o.tensile_strength,"Pa")]),"Joint laws"));let s=Ze("details");s.append(Ze("summary","Case file"));let r=Ze("pre",i.asked.case);r.tabIndex=0,r.setAttribute("aria-label","Text of the case file"),s.append(r),e.append(s)}function _h(i,e){let t=i.found,n=vo(t,"ledger"),s=vo(t,"wall_seconds"),r=vo(t,"friction"),o=Zt(n,"relative_closure"),a=Zt(n,"scheme_passed_share"),l=Zt(t,"peak_memory_bytes"),c=i.frames.list[i.frames.list.length-1];Sa(e,[["Status",gh(i)],["Reason",Xn(t,"reason")],["Simulated time",Wn(Zt(t,"final_time")??c.time)],["Steps",Oi(Zt(t,"steps")??c.step)],["Step cuts",Oi(Zt(t,"cuts"))],["Open-close passes",Oi(Zt(t,"open_close_passes"))],["Blocks, elements (end)",t?`${Oi(Zt(t,"blocks_count"))}, ${Oi(Zt(t,"elements"))}`:Oi(i.model.blocks.length)],["Unknowns (end)",Oi(Zt(t,"unknowns"))],["Contacts (end)",Oi(Zt(t,"contacts"))],["Energy moved",Zt(n,"moved")===void 0?void 0:mn(Zt(n,"moved"),"J")],["Ledger closure",o===void 0?void 0:`${Xt(o)} of ${Xn(n,"relative_closure_of")??"the energy moved"}`],["Largest scheme column",a===void 0?void 0:`${Xt(100*a)} % of the energy passed`],["Friction, worst ratio",Zt(r,"worst_ratio")===void 0?void 0:Xt(Zt(r,"worst_ratio"))],["Wall time",Zt(s,"total")===void 0?void 0:`${Xt(Zt(s,"total"))} s`],["Peak memory",l===void 0?void 0:`${Xt(l/1e6)} MB`],["State hash",Xn(t,"state_hash")]]),t||e.append(Ze("p","The run has no summary: it goes on, or it was killed.","note"));let u=(Array.isArray(t?.blocks)?t.blocks:[]).map(h=>({name:Xn(h,"name")??"",method:Xn(h,"method")??"",displacement:Zt(h,"displacement")??0})).sort((h,f)=>f.displacement-h.displacement).slice(0,8);u.length>0&&e.append(xo(["Block","Method","Mean displacement"],u.map(h=>[h.name,h.method,mn(h.displacement,"m")]),"Blocks that moved farthest")),I_(n,i,e)}function I_(i,e,t){let n=vo(i,"columns");if(!n)return;let s=[];for(let a of e.history.ledger){let l=Zt(vo(n,a.side),a.name);l!==void 0&&l!==0&&s.push([a.name.replaceAll("_"," "),a.side,mn(l,"J"),a.meaning])}let r=Ze("details");r.append(Ze("summary","Energy ledger at the end, column by column"));let o=Ze("div",void 0,"scroll");o.tabIndex=0,o.setAttribute("role","region"),o.setAttribute("aria-label","Energy ledger at the end"),o.append(xo(["Column","Side","Value","Meaning"],s,"Columns that are not zero")),r.append(o),t.append(r)}var L_=new Set(["transfer"]);function xh(i,e,t){let n=[...new Set(i.events.map(l=>l[1]))],s=new Set(n.filter(l=>!L_.has(l))),r=Ze("ol",void 0,"events scroll");r.tabIndex=0,r.setAttribute("aria-label","Events and warnings");let o=()=>{r.replaceChildren(...i.events.filter(l=>s.has(l[1])).map(([l,c,u])=>{let h=Ze("li",void 0,c==="warning"||c==="not_converged"?"warning":""),f=Ze("button",Wn(l),"link");return f.type="button",f.title="Show this instant",f.addEventListener("click",()=>t(l)),h.append(f,Ze("span",c.replaceAll("_"," "),"kind"),Ze("span",u)),h})),r.childElementCount===0&&r.append(Ze("li","none"))},a=Ze("fieldset",void 0,"kinds");a.append(Ze("legend","Kinds"));for(let l of n){let c=Ze("label"),u=Ze("input");u.type="checkbox",u.checked=s.has(l),u.addEventListener("change",()=>{u.checked?s.add(l):s.delete(l),o()}),c.append(u,` ${l.replaceAll("_"," ")} (${i.events.filter(h=>h[1]===l).length})`),a.append(c)}o(),e.replaceChildren(...n.length>0?[a,r]:[Ze("p","The run had no events.")])}function np(i,e,t){if(i.kind==="names")return{what:i.label,ticks:[],names:t};let n=Ds(i.unit,Math.max(Math.abs(e[0]),Math.abs(e[1]))),s=[0,.25,.5,.75,1].map(r=>Xt((e[0]+r*(e[1]-e[0]))/n.factor));return{what:`${i.label} [${n.name}]${i.unit==="Pa"&&i.kind==="signed"?", tension positive":""}`,ticks:s,names:[]}}function ip(i,e,t){if(e.kind==="names"){let o=Ze("div",void 0,"names");for(let[a,l]of t.names){let c=Ze("span"),u=Ze("span",void 0,"swatch");u.style.background=rs(l),c.append(u,a),o.append(c)}i.replaceChildren(Ze("div",t.what,"what"),o);return}let n=e.kind,s=Ze("div",void 0,"ramp");s.style.background=`linear-gradient(to right, ${Array.from({length:17},(o,a)=>rs(fo(n,a/16))).join(", ")})`;let r=Ze("div",void 0,"ticks");for(let o of t.ticks)r.append(Ze("span",o));i.replaceChildren(s,r,Ze("div",t.what,"what"))}var wa=class i{constructor(e){this.channel=new BroadcastChannel("scree-pair");this.channel.onmessage=t=>e(t.data)}static find(e){return window.parent===window?null:new i(e)}tell(e){this.channel.postMessage(e)}};function sp(i,e){let t={...i};for(let[n,[s,r]]of Object.entries(e))t[n]=[Math.min(s,t[n]?.[0]??s),Math.max(r,t[n]?.[1]??r)];return t}function rp(i,e){let t=i.width/Math.max(1,i.clientWidth),[n,s]=[i.clientWidth,i.clientHeight],r=34,o=62,a=document.createElement("canvas");a.width=Math.round(n*t),a.height=Math.round((s+r+o)*t);let l=a.getContext("2d");l.scale(t,t);let c=e.dark?"#e6e8e8":"#1e2226";l.fillStyle=e.dark?"#1c2024":"#ffffff",l.fillRect(0,0,n,s+r+o),l.drawImage(i,0,r,n,s),l.fillStyle=l.strokeStyle=c,l.font="600 15px system-ui, sans-serif",l.textBaseline="middle";let u=l.measureText(e.instant).width;l.fillText(e.title,12,r/2,Math.max(60,n-u-40)),l.textAlign="right",l.fillText(e.instant,n-12,r/2),l.textAlign="left",l.font="12px system-ui, sans-serif";for(let[f,d,_]of e.labels)d>0&&d<n&&_>0&&_<s&&l.fillText(f,d,r+_);let h=r+s+16;return l.lineWidth=1,l.beginPath(),l.moveTo(12,h-4),l.lineTo(12,h+4),l.lineTo(12+e.scale.pixels,h+4),l.lineTo(12+e.scale.pixels,h-4),l.stroke(),l.fillText(e.scale.text,20+e.scale.pixels,h),D_(l,e,Math.max(n-320,n/2),h,Math.min(300,n/2-20)),new Promise((f,d)=>a.toBlob(_=>_?f(_):d(new Error("the picture is too large to save")),"image/png"))}function D_(i,e,t,n,s){let r=i.fillStyle;if(e.field.kind==="names"){let o=t;for(let[a,l]of e.legend.names){if(o>t+s-40)break;i.fillStyle=rs(l),i.fillRect(o,n-6,12,12),i.fillStyle=r,i.fillText(a,o+17,n),o+=30+i.measureText(a).width}i.fillText(e.legend.what,t,n+32);return}for(let o=0;o<128;++o)i.fillStyle=rs(fo(e.field.kind,o/127)),i.fillRect(t+o/128*s,n-7,s/128+.6,12);i.fillStyle=r,e.legend.ticks.forEach((o,a,l)=>{i.textAlign=a===0?"left":a===l.length-1?"right":"center",i.fillText(o,t+a/(l.length-1)*s,n+15)}),i.textAlign="left",i.fillText(e.legend.what,t,n+32)}var Sp=0,$h=1,wp=2;var Zh=1,Tp=2,Ti=3,Wi=0,Rn=1,Ei=2,Yi=0,Hs=1,Jh=2,Kh=3,jh=4,Ep=5,ms=100,Ap=101,Cp=102,Rp=103,Pp=104,Ip=200,Lp=201,Dp=202,Up=203,Wa=204,Xa=205,Fp=206,Np=207,Op=208,Bp=209,kp=210,zp=211,Vp=212,Hp=213,Gp=214,pl=0,ml=1,gl=2,Gs=3,_l=4,xl=5,vl=6,yl=7,Qh=0,Wp=1,Xp=2,$i=0,qp=1,Yp=2,$p=3,Zp=4,Jp=5,Kp=6,jp=7;var eu=300,$s=301,Zs=302,Ml=303,bl=304,Go=306,qa=1e3,ps=1001,Ya=1002,Un=1003,Qp=1004;var Wo=1005;var Zn=1006,Sl=1007;var vs=1008;var Ai=1009,tu=1010,nu=1011,Wr=1012,wl=1013,ys=1014,Ci=1015,Xr=1016,Tl=1017,El=1018,qr=1020,iu=35902,su=1021,ru=1022,Nn=1023,Nr=1026,Yr=1027,ou=1028,Al=1029,au=1030,Cl=1031;var Rl=1033,Xo=33776,qo=33777,Yo=33778,$o=33779,Pl=35840,Il=35841,Ll=35842,Dl=35843,Ul=36196,Fl=37492,Nl=37496,Ol=37808,Bl=37809,kl=37810,zl=37811,Vl=37812,Hl=37813,Gl=37814,Wl=37815,Xl=37816,ql=37817,Yl=37818,$l=37819,Zl=37820,Jl=37821,Zo=36492,Kl=36494,jl=36495,lu=36283,Ql=36284,ec=36285,tc=36286;var To=2300,$a=2301,Ga=2302,Hh=2400,Gh=2401,Wh=2402;var em=3200,tm=3201;var nm=0,im=1,Zi="",$n="srgb",Ws="srgb-linear",Eo="linear",wt="srgb";var zs=7680;var Xh=519,sm=512,rm=513,om=514,cu=515,am=516,lm=517,cm=518,hm=519,qh=35044;var $r="300 es",Mi=2e3,Ao=2001;var Xi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},_n=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var vh=Math.PI/180,Za=180/Math.PI;function Jo(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(_n[i&255]+_n[i>>8&255]+_n[i>>16&255]+_n[i>>24&255]+"-"+_n[e&255]+_n[e>>8&255]+"-"+_n[e>>16&15|64]+_n[e>>24&255]+"-"+_n[t&63|128]+_n[t>>8&255]+"-"+_n[t>>16&255]+_n[t>>24&255]+_n[n&255]+_n[n>>8&255]+_n[n>>16&255]+_n[n>>24&255]).toLowerCase()}function ht(i,e,t){return Math.max(e,Math.min(t,i))}function U_(i,e){return(i%e+e)%e}function yh(i,e,t){return(1-t)*i+t*e}function yo(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Ln(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var Tt=class i{constructor(e=0,t=0){i.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ht(this.x,e.x,t.x),this.y=ht(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ht(this.x,e,t),this.y=ht(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ht(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ht(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},qi=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],f=r[o+0],d=r[o+1],_=r[o+2],M=r[o+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h;return}if(a===1){e[t+0]=f,e[t+1]=d,e[t+2]=_,e[t+3]=M;return}if(h!==M||l!==f||c!==d||u!==_){let m=1-a,p=l*f+c*d+u*_+h*M,E=p>=0?1:-1,w=1-p*p;if(w>Number.EPSILON){let F=Math.sqrt(w),I=Math.atan2(F,p*E);m=Math.sin(m*I)/F,a=Math.sin(a*I)/F}let y=a*E;if(l=l*m+f*y,c=c*m+d*y,u=u*m+_*y,h=h*m+M*y,m===1-a){let F=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=F,c*=F,u*=F,h*=F}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],f=r[o+1],d=r[o+2],_=r[o+3];return e[t]=a*_+u*h+l*d-c*f,e[t+1]=l*_+u*f+c*h-a*d,e[t+2]=c*_+u*d+a*f-l*h,e[t+3]=u*_-a*h-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),f=l(n/2),d=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*_,this._y=c*d*h-f*u*_,this._z=c*u*_+f*d*h,this._w=c*u*h-f*d*_;break;case"YXZ":this._x=f*u*h+c*d*_,this._y=c*d*h-f*u*_,this._z=c*u*_-f*d*h,this._w=c*u*h+f*d*_;break;case"ZXY":this._x=f*u*h-c*d*_,this._y=c*d*h+f*u*_,this._z=c*u*_+f*d*h,this._w=c*u*h-f*d*_;break;case"ZYX":this._x=f*u*h-c*d*_,this._y=c*d*h+f*u*_,this._z=c*u*_-f*d*h,this._w=c*u*h+f*d*_;break;case"YZX":this._x=f*u*h+c*d*_,this._y=c*d*h+f*u*_,this._z=c*u*_-f*d*h,this._w=c*u*h-f*d*_;break;case"XZY":this._x=f*u*h-c*d*_,this._y=c*d*h-f*u*_,this._z=c*u*_+f*d*h,this._w=c*u*h+f*d*_;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=n+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>h){let d=2*Math.sqrt(1+n-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-n-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ht(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*e._w+n*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let d=1-t;return this._w=d*o+t*this._w,this._x=d*n+t*this._x,this._y=d*s+t*this._y,this._z=d*r+t*this._z,this.normalize(),this}let c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-t)*u)/c,f=Math.sin(t*u)/c;return this._w=o*h+this._w*f,this._x=n*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},J=class i{constructor(e=0,t=0,n=0){i.prototype.isVector3=!0,this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(op.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(op.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ht(this.x,e.x,t.x),this.y=ht(this.y,e.y,t.y),this.z=ht(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ht(this.x,e,t),this.y=ht(this.y,e,t),this.z=ht(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ht(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Mh.copy(this).projectOnVector(e),this.sub(Mh)}reflect(e){return this.sub(Mh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ht(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Mh=new J,op=new qi,et=class i{constructor(e,t,n,s,r,o,a,l,c){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],d=n[5],_=n[8],M=s[0],m=s[3],p=s[6],E=s[1],w=s[4],y=s[7],F=s[2],I=s[5],L=s[8];return r[0]=o*M+a*E+l*F,r[3]=o*m+a*w+l*I,r[6]=o*p+a*y+l*L,r[1]=c*M+u*E+h*F,r[4]=c*m+u*w+h*I,r[7]=c*p+u*y+h*L,r[2]=f*M+d*E+_*F,r[5]=f*m+d*w+_*I,r[8]=f*p+d*y+_*L,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,_=t*h+n*f+s*d;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let M=1/_;return e[0]=h*M,e[1]=(s*c-u*n)*M,e[2]=(a*n-s*o)*M,e[3]=f*M,e[4]=(u*t-s*l)*M,e[5]=(s*r-a*t)*M,e[6]=d*M,e[7]=(n*l-c*t)*M,e[8]=(o*t-n*r)*M,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(bh.makeScale(e,t)),this}rotate(e){return this.premultiply(bh.makeRotation(-e)),this}translate(e,t){return this.premultiply(bh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},bh=new et;function hu(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Co(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function um(){let i=Co("canvas");return i.style.display="block",i}var ap={};function Xs(i){i in ap||(ap[i]=!0,console.warn(i))}function fm(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}function dm(i){let e=i.elements;e[2]=.5*e[2]+.5*e[3],e[6]=.5*e[6]+.5*e[7],e[10]=.5*e[10]+.5*e[11],e[14]=.5*e[14]+.5*e[15]}function pm(i){let e=i.elements;e[11]===-1?(e[10]=-e[10]-1,e[14]=-e[14]):(e[10]=-e[10],e[14]=-e[14]+1)}var lp=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),cp=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function F_(){let i={enabled:!0,workingColorSpace:Ws,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===wt&&(s.r=Gi(s.r),s.g=Gi(s.g),s.b=Gi(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===wt&&(s.r=Fr(s.r),s.g=Fr(s.g),s.b=Fr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Zi?Eo:this.spaces[s].transfer},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return Xs("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return Xs("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ws]:{primaries:e,whitePoint:n,transfer:Eo,toXYZ:lp,fromXYZ:cp,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:$n},outputColorSpaceConfig:{drawingBufferColorSpace:$n}},[$n]:{primaries:e,whitePoint:n,transfer:wt,toXYZ:lp,fromXYZ:cp,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:$n}}}),i}var ct=F_();function Gi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Fr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Sr,Ja=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Sr===void 0&&(Sr=Co("canvas")),Sr.width=e.width,Sr.height=e.height;let s=Sr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Sr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Co("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Gi(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Gi(t[n]/255)*255):t[n]=Gi(t[n]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},N_=0,Or=class{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:N_++}),this.uuid=Jo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Sh(s[o].image)):r.push(Sh(s[o]))}else r=Sh(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Sh(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Ja.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var O_=0,wh=new J,Fn=class i extends Xi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=ps,s=ps,r=Zn,o=vs,a=Nn,l=Ai,c=i.DEFAULT_ANISOTROPY,u=Zi){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:O_++}),this.uuid=Jo(),this.name="",this.source=new Or(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Tt(0,0),this.repeat=new Tt(1,1),this.center=new Tt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(wh).x}get height(){return this.source.getSize(wh).y}get depth(){return this.source.getSize(wh).z}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==eu)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case qa:e.x=e.x-Math.floor(e.x);break;case ps:e.x=e.x<0?0:1;break;case Ya:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case qa:e.y=e.y-Math.floor(e.y);break;case ps:e.y=e.y<0?0:1;break;case Ya:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Fn.DEFAULT_IMAGE=null;Fn.DEFAULT_MAPPING=eu;Fn.DEFAULT_ANISOTROPY=1;var zt=class i{constructor(e=0,t=0,n=0,s=1){i.prototype.isVector4=!0,this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],_=l[9],M=l[2],m=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-M)<.01&&Math.abs(_-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+M)<.1&&Math.abs(_+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let w=(c+1)/2,y=(d+1)/2,F=(p+1)/2,I=(u+f)/4,L=(h+M)/4,B=(_+m)/4;return w>y&&w>F?w<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(w),s=I/n,r=L/n):y>F?y<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),n=I/s,r=B/s):F<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(F),n=L/r,s=B/r),this.set(n,s,r,t),this}let E=Math.sqrt((m-_)*(m-_)+(h-M)*(h-M)+(f-u)*(f-u));return Math.abs(E)<.001&&(E=1),this.x=(m-_)/E,this.y=(h-M)/E,this.z=(f-u)/E,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ht(this.x,e.x,t.x),this.y=ht(this.y,e.y,t.y),this.z=ht(this.z,e.z,t.z),this.w=ht(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ht(this.x,e,t),this.y=ht(this.y,e,t),this.z=ht(this.z,e,t),this.w=ht(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ht(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ka=class extends Xi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Zn,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new zt(0,0,e,t),this.scissorTest=!1,this.viewport=new zt(0,0,e,t);let s={width:e,height:t,depth:n.depth},r=new Fn(s);this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(e={}){let t={minFilter:Zn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Or(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Si=class extends Ka{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Ro=class extends Fn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Un,this.minFilter=Un,this.wrapR=ps,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var ja=class extends Fn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Un,this.minFilter=Un,this.wrapR=ps,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var gs=class{constructor(e=new J(1/0,1/0,1/0),t=new J(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(hi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(hi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=hi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,hi):hi.fromBufferAttribute(r,o),hi.applyMatrix4(e.matrixWorld),this.expandByPoint(hi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ta.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ta.copy(n.boundingBox)),Ta.applyMatrix4(e.matrixWorld),this.union(Ta)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,hi),hi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Mo),Ea.subVectors(this.max,Mo),wr.subVectors(e.a,Mo),Tr.subVectors(e.b,Mo),Er.subVectors(e.c,Mo),as.subVectors(Tr,wr),ls.subVectors(Er,Tr),Ns.subVectors(wr,Er);let t=[0,-as.z,as.y,0,-ls.z,ls.y,0,-Ns.z,Ns.y,as.z,0,-as.x,ls.z,0,-ls.x,Ns.z,0,-Ns.x,-as.y,as.x,0,-ls.y,ls.x,0,-Ns.y,Ns.x,0];return!Th(t,wr,Tr,Er,Ea)||(t=[1,0,0,0,1,0,0,0,1],!Th(t,wr,Tr,Er,Ea))?!1:(Aa.crossVectors(as,ls),t=[Aa.x,Aa.y,Aa.z],Th(t,wr,Tr,Er,Ea))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,hi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(hi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Bi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Bi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Bi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Bi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Bi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Bi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Bi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Bi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Bi),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Bi=[new J,new J,new J,new J,new J,new J,new J,new J],hi=new J,Ta=new gs,wr=new J,Tr=new J,Er=new J,as=new J,ls=new J,Ns=new J,Mo=new J,Ea=new J,Aa=new J,Os=new J;function Th(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Os.fromArray(i,r);let a=s.x*Math.abs(Os.x)+s.y*Math.abs(Os.y)+s.z*Math.abs(Os.z),l=e.dot(Os),c=t.dot(Os),u=n.dot(Os);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var B_=new gs,bo=new J,Eh=new J,Br=class{constructor(e=new J,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):B_.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;bo.subVectors(e,this.center);let t=bo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(bo,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Eh.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(bo.copy(e.center).add(Eh)),this.expandByPoint(bo.copy(e.center).sub(Eh))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},ki=new J,Ah=new J,Ca=new J,cs=new J,Ch=new J,Ra=new J,Rh=new J,Qa=class{constructor(e=new J,t=new J(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ki)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ki.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ki.copy(this.origin).addScaledVector(this.direction,t),ki.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Ah.copy(e).add(t).multiplyScalar(.5),Ca.copy(t).sub(e).normalize(),cs.copy(this.origin).sub(Ah);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Ca),a=cs.dot(this.direction),l=-cs.dot(Ca),c=cs.lengthSq(),u=Math.abs(1-o*o),h,f,d,_;if(u>0)if(h=o*l-a,f=o*a-l,_=r*u,h>=0)if(f>=-_)if(f<=_){let M=1/u;h*=M,f*=M,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-_?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=_?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Ah).addScaledVector(Ca,f),d}intersectSphere(e,t){ki.subVectors(e.center,this.origin);let n=ki.dot(this.direction),s=ki.dot(ki)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,ki)!==null}intersectTriangle(e,t,n,s,r){Ch.subVectors(t,e),Ra.subVectors(n,e),Rh.crossVectors(Ch,Ra);let o=this.direction.dot(Rh),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;cs.subVectors(this.origin,e);let l=a*this.direction.dot(Ra.crossVectors(cs,Ra));if(l<0)return null;let c=a*this.direction.dot(Ch.cross(cs));if(c<0||l+c>o)return null;let u=-a*cs.dot(Rh);return u<0?null:this.at(u/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Kt=class i{constructor(e,t,n,s,r,o,a,l,c,u,h,f,d,_,M,m){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,h,f,d,_,M,m)}set(e,t,n,s,r,o,a,l,c,u,h,f,d,_,M,m){let p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=_,p[11]=M,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){let t=this.elements,n=e.elements,s=1/Ar.setFromMatrixColumn(e,0).length(),r=1/Ar.setFromMatrixColumn(e,1).length(),o=1/Ar.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,d=o*h,_=a*u,M=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=d+_*c,t[5]=f-M*c,t[9]=-a*l,t[2]=M-f*c,t[6]=_+d*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,d=l*h,_=c*u,M=c*h;t[0]=f+M*a,t[4]=_*a-d,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=d*a-_,t[6]=M+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,d=l*h,_=c*u,M=c*h;t[0]=f-M*a,t[4]=-o*h,t[8]=_+d*a,t[1]=d+_*a,t[5]=o*u,t[9]=M-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,d=o*h,_=a*u,M=a*h;t[0]=l*u,t[4]=_*c-d,t[8]=f*c+M,t[1]=l*h,t[5]=M*c+f,t[9]=d*c-_,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,d=o*c,_=a*l,M=a*c;t[0]=l*u,t[4]=M-f*h,t[8]=_*h+d,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*h+_,t[10]=f-M*h}else if(e.order==="XZY"){let f=o*l,d=o*c,_=a*l,M=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+M,t[5]=o*u,t[9]=d*h-_,t[2]=_*h-d,t[6]=a*u,t[10]=M*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(k_,e,z_)}lookAt(e,t,n){let s=this.elements;return qn.subVectors(e,t),qn.lengthSq()===0&&(qn.z=1),qn.normalize(),hs.crossVectors(n,qn),hs.lengthSq()===0&&(Math.abs(n.z)===1?qn.x+=1e-4:qn.z+=1e-4,qn.normalize(),hs.crossVectors(n,qn)),hs.normalize(),Pa.crossVectors(qn,hs),s[0]=hs.x,s[4]=Pa.x,s[8]=qn.x,s[1]=hs.y,s[5]=Pa.y,s[9]=qn.y,s[2]=hs.z,s[6]=Pa.z,s[10]=qn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],d=n[13],_=n[2],M=n[6],m=n[10],p=n[14],E=n[3],w=n[7],y=n[11],F=n[15],I=s[0],L=s[4],B=s[8],T=s[12],b=s[1],R=s[5],X=s[9],k=s[13],G=s[2],Y=s[6],q=s[10],K=s[14],j=s[3],ce=s[7],le=s[11],ge=s[15];return r[0]=o*I+a*b+l*G+c*j,r[4]=o*L+a*R+l*Y+c*ce,r[8]=o*B+a*X+l*q+c*le,r[12]=o*T+a*k+l*K+c*ge,r[1]=u*I+h*b+f*G+d*j,r[5]=u*L+h*R+f*Y+d*ce,r[9]=u*B+h*X+f*q+d*le,r[13]=u*T+h*k+f*K+d*ge,r[2]=_*I+M*b+m*G+p*j,r[6]=_*L+M*R+m*Y+p*ce,r[10]=_*B+M*X+m*q+p*le,r[14]=_*T+M*k+m*K+p*ge,r[3]=E*I+w*b+y*G+F*j,r[7]=E*L+w*R+y*Y+F*ce,r[11]=E*B+w*X+y*q+F*le,r[15]=E*T+w*k+y*K+F*ge,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],d=e[14],_=e[3],M=e[7],m=e[11],p=e[15];return _*(+r*l*h-s*c*h-r*a*f+n*c*f+s*a*d-n*l*d)+M*(+t*l*d-t*c*f+r*o*f-s*o*d+s*c*u-r*l*u)+m*(+t*c*h-t*a*d-r*o*h+n*o*d+r*a*u-n*c*u)+p*(-s*a*u-t*l*h+t*a*f+s*o*h-n*o*f+n*l*u)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],d=e[11],_=e[12],M=e[13],m=e[14],p=e[15],E=h*m*c-M*f*c+M*l*d-a*m*d-h*l*p+a*f*p,w=_*f*c-u*m*c-_*l*d+o*m*d+u*l*p-o*f*p,y=u*M*c-_*h*c+_*a*d-o*M*d-u*a*p+o*h*p,F=_*h*l-u*M*l-_*a*f+o*M*f+u*a*m-o*h*m,I=t*E+n*w+s*y+r*F;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let L=1/I;return e[0]=E*L,e[1]=(M*f*r-h*m*r-M*s*d+n*m*d+h*s*p-n*f*p)*L,e[2]=(a*m*r-M*l*r+M*s*c-n*m*c-a*s*p+n*l*p)*L,e[3]=(h*l*r-a*f*r-h*s*c+n*f*c+a*s*d-n*l*d)*L,e[4]=w*L,e[5]=(u*m*r-_*f*r+_*s*d-t*m*d-u*s*p+t*f*p)*L,e[6]=(_*l*r-o*m*r-_*s*c+t*m*c+o*s*p-t*l*p)*L,e[7]=(o*f*r-u*l*r+u*s*c-t*f*c-o*s*d+t*l*d)*L,e[8]=y*L,e[9]=(_*h*r-u*M*r-_*n*d+t*M*d+u*n*p-t*h*p)*L,e[10]=(o*M*r-_*a*r+_*n*c-t*M*c-o*n*p+t*a*p)*L,e[11]=(u*a*r-o*h*r-u*n*c+t*h*c+o*n*d-t*a*d)*L,e[12]=F*L,e[13]=(u*M*s-_*h*s+_*n*f-t*M*f-u*n*m+t*h*m)*L,e[14]=(_*a*s-o*M*s-_*n*l+t*M*l+o*n*m-t*a*m)*L,e[15]=(o*h*s-u*a*s+u*n*l-t*h*l-o*n*f+t*a*f)*L,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,_=r*h,M=o*u,m=o*h,p=a*h,E=l*c,w=l*u,y=l*h,F=n.x,I=n.y,L=n.z;return s[0]=(1-(M+p))*F,s[1]=(d+y)*F,s[2]=(_-w)*F,s[3]=0,s[4]=(d-y)*I,s[5]=(1-(f+p))*I,s[6]=(m+E)*I,s[7]=0,s[8]=(_+w)*L,s[9]=(m-E)*L,s[10]=(1-(f+M))*L,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements,r=Ar.set(s[0],s[1],s[2]).length(),o=Ar.set(s[4],s[5],s[6]).length(),a=Ar.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],ui.copy(this);let c=1/r,u=1/o,h=1/a;return ui.elements[0]*=c,ui.elements[1]*=c,ui.elements[2]*=c,ui.elements[4]*=u,ui.elements[5]*=u,ui.elements[6]*=u,ui.elements[8]*=h,ui.elements[9]*=h,ui.elements[10]*=h,t.setFromRotationMatrix(ui),n.x=r,n.y=o,n.z=a,this}makePerspective(e,t,n,s,r,o,a=Mi){let l=this.elements,c=2*r/(t-e),u=2*r/(n-s),h=(t+e)/(t-e),f=(n+s)/(n-s),d,_;if(a===Mi)d=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===Ao)d=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=h,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=d,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Mi){let l=this.elements,c=1/(t-e),u=1/(n-s),h=1/(o-r),f=(t+e)*c,d=(n+s)*u,_,M;if(a===Mi)_=(o+r)*h,M=-2*h;else if(a===Ao)_=r*h,M=-1*h;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-f,l[1]=0,l[5]=2*u,l[9]=0,l[13]=-d,l[2]=0,l[6]=0,l[10]=M,l[14]=-_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Ar=new J,ui=new Kt,k_=new J(0,0,0),z_=new J(1,1,1),hs=new J,Pa=new J,qn=new J,hp=new Kt,up=new qi,wi=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(ht(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ht(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(ht(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ht(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ht(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ht(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return hp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(hp,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return up.setFromEuler(this),this.setFromQuaternion(up,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};wi.DEFAULT_ORDER="XYZ";var Po=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},V_=0,fp=new J,Cr=new qi,zi=new Kt,Ia=new J,So=new J,H_=new J,G_=new qi,dp=new J(1,0,0),pp=new J(0,1,0),mp=new J(0,0,1),gp={type:"added"},W_={type:"removed"},Rr={type:"childadded",child:null},Ph={type:"childremoved",child:null},ni=class i extends Xi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:V_++}),this.uuid=Jo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new J,t=new wi,n=new qi,s=new J(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Kt},normalMatrix:{value:new et}}),this.matrix=new Kt,this.matrixWorld=new Kt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Po,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Cr.setFromAxisAngle(e,t),this.quaternion.multiply(Cr),this}rotateOnWorldAxis(e,t){return Cr.setFromAxisAngle(e,t),this.quaternion.premultiply(Cr),this}rotateX(e){return this.rotateOnAxis(dp,e)}rotateY(e){return this.rotateOnAxis(pp,e)}rotateZ(e){return this.rotateOnAxis(mp,e)}translateOnAxis(e,t){return fp.copy(e).applyQuaternion(this.quaternion),this.position.add(fp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(dp,e)}translateY(e){return this.translateOnAxis(pp,e)}translateZ(e){return this.translateOnAxis(mp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(zi.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Ia.copy(e):Ia.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),So.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?zi.lookAt(So,Ia,this.up):zi.lookAt(Ia,So,this.up),this.quaternion.setFromRotationMatrix(zi),s&&(zi.extractRotation(s.matrixWorld),Cr.setFromRotationMatrix(zi),this.quaternion.premultiply(Cr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(gp),Rr.child=e,this.dispatchEvent(Rr),Rr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(W_),Ph.child=e,this.dispatchEvent(Ph),Ph.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),zi.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),zi.multiply(e.parent.matrixWorld)),e.applyMatrix4(zi),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(gp),Rr.child=e,this.dispatchEvent(Rr),Rr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(So,e,H_),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(So,G_,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t){let n=this.parent;if(e===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),d=o(e.animations),_=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),_.length>0&&(n.nodes=_)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}};ni.DEFAULT_UP=new J(0,1,0);ni.DEFAULT_MATRIX_AUTO_UPDATE=!0;ni.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var fi=new J,Vi=new J,Ih=new J,Hi=new J,Pr=new J,Ir=new J,_p=new J,Lh=new J,Dh=new J,Uh=new J,Fh=new zt,Nh=new zt,Oh=new zt,ds=class i{constructor(e=new J,t=new J,n=new J){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),fi.subVectors(e,t),s.cross(fi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){fi.subVectors(s,t),Vi.subVectors(n,t),Ih.subVectors(e,t);let o=fi.dot(fi),a=fi.dot(Vi),l=fi.dot(Ih),c=Vi.dot(Vi),u=Vi.dot(Ih),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,_=(o*u-a*l)*f;return r.set(1-d-_,_,d)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Hi)===null?!1:Hi.x>=0&&Hi.y>=0&&Hi.x+Hi.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Hi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Hi.x),l.addScaledVector(o,Hi.y),l.addScaledVector(a,Hi.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Fh.setScalar(0),Nh.setScalar(0),Oh.setScalar(0),Fh.fromBufferAttribute(e,t),Nh.fromBufferAttribute(e,n),Oh.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Fh,r.x),o.addScaledVector(Nh,r.y),o.addScaledVector(Oh,r.z),o}static isFrontFacing(e,t,n,s){return fi.subVectors(n,t),Vi.subVectors(e,t),fi.cross(Vi).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return fi.subVectors(this.c,this.b),Vi.subVectors(this.a,this.b),fi.cross(Vi).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Pr.subVectors(s,n),Ir.subVectors(r,n),Lh.subVectors(e,n);let l=Pr.dot(Lh),c=Ir.dot(Lh);if(l<=0&&c<=0)return t.copy(n);Dh.subVectors(e,s);let u=Pr.dot(Dh),h=Ir.dot(Dh);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),t.copy(n).addScaledVector(Pr,o);Uh.subVectors(e,r);let d=Pr.dot(Uh),_=Ir.dot(Uh);if(_>=0&&d<=_)return t.copy(r);let M=d*c-l*_;if(M<=0&&c>=0&&_<=0)return a=c/(c-_),t.copy(n).addScaledVector(Ir,a);let m=u*_-d*h;if(m<=0&&h-u>=0&&d-_>=0)return _p.subVectors(r,s),a=(h-u)/(h-u+(d-_)),t.copy(s).addScaledVector(_p,a);let p=1/(m+M+f);return o=M*p,a=f*p,t.copy(n).addScaledVector(Pr,o).addScaledVector(Ir,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},mm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},us={h:0,s:0,l:0},La={h:0,s:0,l:0};function Bh(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var yt=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=$n){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,ct.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=ct.workingColorSpace){return this.r=e,this.g=t,this.b=n,ct.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=ct.workingColorSpace){if(e=U_(e,1),t=ht(t,0,1),n=ht(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Bh(o,r,e+1/3),this.g=Bh(o,r,e),this.b=Bh(o,r,e-1/3)}return ct.colorSpaceToWorking(this,s),this}setStyle(e,t=$n){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=$n){let n=mm[e.toLowerCase()];return n!==void 0?this.setHex(n,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Gi(e.r),this.g=Gi(e.g),this.b=Gi(e.b),this}copyLinearToSRGB(e){return this.r=Fr(e.r),this.g=Fr(e.g),this.b=Fr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=$n){return ct.workingToColorSpace(xn.copy(this),e),Math.round(ht(xn.r*255,0,255))*65536+Math.round(ht(xn.g*255,0,255))*256+Math.round(ht(xn.b*255,0,255))}getHexString(e=$n){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=ct.workingColorSpace){ct.workingToColorSpace(xn.copy(this),t);let n=xn.r,s=xn.g,r=xn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=ct.workingColorSpace){return ct.workingToColorSpace(xn.copy(this),t),e.r=xn.r,e.g=xn.g,e.b=xn.b,e}getStyle(e=$n){ct.workingToColorSpace(xn.copy(this),e);let t=xn.r,n=xn.g,s=xn.b;return e!==$n?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(us),this.setHSL(us.h+e,us.s+t,us.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(us),e.getHSL(La);let n=yh(us.h,La.h,t),s=yh(us.s,La.s,t),r=yh(us.l,La.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},xn=new yt;yt.NAMES=mm;var X_=0,qs=class extends Xi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:X_++}),this.uuid=Jo(),this.name="",this.type="Material",this.blending=Hs,this.side=Wi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Wa,this.blendDst=Xa,this.blendEquation=ms,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new yt(0,0,0),this.blendAlpha=0,this.depthFunc=Gs,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Xh,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=zs,this.stencilZFail=zs,this.stencilZPass=zs,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==Hs&&(n.blending=this.blending),this.side!==Wi&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==Wa&&(n.blendSrc=this.blendSrc),this.blendDst!==Xa&&(n.blendDst=this.blendDst),this.blendEquation!==ms&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==Gs&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Xh&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==zs&&(n.stencilFail=this.stencilFail),this.stencilZFail!==zs&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==zs&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},Io=class extends qs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new yt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new wi,this.combine=Qh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var Jt=new J,Da=new Tt,q_=0,jt=class{constructor(e,t,n=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:q_++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=qh,this.updateRanges=[],this.gpuType=Ci,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Da.fromBufferAttribute(this,t),Da.applyMatrix3(e),this.setXY(t,Da.x,Da.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Jt.fromBufferAttribute(this,t),Jt.applyMatrix3(e),this.setXYZ(t,Jt.x,Jt.y,Jt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Jt.fromBufferAttribute(this,t),Jt.applyMatrix4(e),this.setXYZ(t,Jt.x,Jt.y,Jt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Jt.fromBufferAttribute(this,t),Jt.applyNormalMatrix(e),this.setXYZ(t,Jt.x,Jt.y,Jt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Jt.fromBufferAttribute(this,t),Jt.transformDirection(e),this.setXYZ(t,Jt.x,Jt.y,Jt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=yo(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Ln(n,this.array)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=yo(t,this.array)),t}setX(e,t){return this.normalized&&(t=Ln(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=yo(t,this.array)),t}setY(e,t){return this.normalized&&(t=Ln(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=yo(t,this.array)),t}setZ(e,t){return this.normalized&&(t=Ln(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=yo(t,this.array)),t}setW(e,t){return this.normalized&&(t=Ln(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=Ln(t,this.array),n=Ln(n,this.array)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=Ln(t,this.array),n=Ln(n,this.array),s=Ln(s,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=Ln(t,this.array),n=Ln(n,this.array),s=Ln(s,this.array),r=Ln(r,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==qh&&(e.usage=this.usage),e}};var Lo=class extends jt{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Do=class extends jt{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var bi=class extends jt{constructor(e,t,n){super(new Float32Array(e),t,n)}},Y_=0,ti=new Kt,kh=new ni,Lr=new J,Yn=new gs,wo=new gs,fn=new J,ii=class i extends Xi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Y_++}),this.uuid=Jo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(hu(e)?Do:Lo)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new et().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return ti.makeRotationFromQuaternion(e),this.applyMatrix4(ti),this}rotateX(e){return ti.makeRotationX(e),this.applyMatrix4(ti),this}rotateY(e){return ti.makeRotationY(e),this.applyMatrix4(ti),this}rotateZ(e){return ti.makeRotationZ(e),this.applyMatrix4(ti),this}translate(e,t,n){return ti.makeTranslation(e,t,n),this.applyMatrix4(ti),this}scale(e,t,n){return ti.makeScale(e,t,n),this.applyMatrix4(ti),this}lookAt(e){return kh.lookAt(e),kh.updateMatrix(),this.applyMatrix4(kh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Lr).negate(),this.translate(Lr.x,Lr.y,Lr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new bi(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new gs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new J(-1/0,-1/0,-1/0),new J(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];Yn.setFromBufferAttribute(r),this.morphTargetsRelative?(fn.addVectors(this.boundingBox.min,Yn.min),this.boundingBox.expandByPoint(fn),fn.addVectors(this.boundingBox.max,Yn.max),this.boundingBox.expandByPoint(fn)):(this.boundingBox.expandByPoint(Yn.min),this.boundingBox.expandByPoint(Yn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Br);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new J,1/0);return}if(e){let n=this.boundingSphere.center;if(Yn.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];wo.setFromBufferAttribute(a),this.morphTargetsRelative?(fn.addVectors(Yn.min,wo.min),Yn.expandByPoint(fn),fn.addVectors(Yn.max,wo.max),Yn.expandByPoint(fn)):(Yn.expandByPoint(wo.min),Yn.expandByPoint(wo.max))}Yn.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)fn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(fn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)fn.fromBufferAttribute(a,c),l&&(Lr.fromBufferAttribute(e,c),fn.add(Lr)),s=Math.max(s,n.distanceToSquared(fn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new jt(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let B=0;B<n.count;B++)a[B]=new J,l[B]=new J;let c=new J,u=new J,h=new J,f=new Tt,d=new Tt,_=new Tt,M=new J,m=new J;function p(B,T,b){c.fromBufferAttribute(n,B),u.fromBufferAttribute(n,T),h.fromBufferAttribute(n,b),f.fromBufferAttribute(r,B),d.fromBufferAttribute(r,T),_.fromBufferAttribute(r,b),u.sub(c),h.sub(c),d.sub(f),_.sub(f);let R=1/(d.x*_.y-_.x*d.y);isFinite(R)&&(M.copy(u).multiplyScalar(_.y).addScaledVector(h,-d.y).multiplyScalar(R),m.copy(h).multiplyScalar(d.x).addScaledVector(u,-_.x).multiplyScalar(R),a[B].add(M),a[T].add(M),a[b].add(M),l[B].add(m),l[T].add(m),l[b].add(m))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let B=0,T=E.length;B<T;++B){let b=E[B],R=b.start,X=b.count;for(let k=R,G=R+X;k<G;k+=3)p(e.getX(k+0),e.getX(k+1),e.getX(k+2))}let w=new J,y=new J,F=new J,I=new J;function L(B){F.fromBufferAttribute(s,B),I.copy(F);let T=a[B];w.copy(T),w.sub(F.multiplyScalar(F.dot(T))).normalize(),y.crossVectors(I,T);let R=y.dot(l[B])<0?-1:1;o.setXYZW(B,w.x,w.y,w.z,R)}for(let B=0,T=E.length;B<T;++B){let b=E[B],R=b.start,X=b.count;for(let k=R,G=R+X;k<G;k+=3)L(e.getX(k+0)),L(e.getX(k+1)),L(e.getX(k+2))}}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new jt(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let s=new J,r=new J,o=new J,a=new J,l=new J,c=new J,u=new J,h=new J;if(e)for(let f=0,d=e.count;f<d;f+=3){let _=e.getX(f+0),M=e.getX(f+1),m=e.getX(f+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,M),o.fromBufferAttribute(t,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,_),l.fromBufferAttribute(n,M),c.fromBufferAttribute(n,m),a.add(u),l.add(u),c.add(u),n.setXYZ(_,a.x,a.y,a.z),n.setXYZ(M,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)fn.fromBufferAttribute(e,t),fn.normalize(),e.setXYZ(t,fn.x,fn.y,fn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,_=0;for(let M=0,m=l.length;M<m;M++){a.isInterleavedBufferAttribute?d=l[M]*a.data.stride+a.offset:d=l[M]*u;for(let p=0;p<u;p++)f[_++]=c[d++]}return new jt(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=e(f,n);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},xp=new Kt,Bs=new Qa,Ua=new Br,vp=new J,Fa=new J,Na=new J,Oa=new J,zh=new J,Ba=new J,yp=new J,ka=new J,Cn=class extends ni{constructor(e=new ii,t=new Io){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Ba.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(zh.fromBufferAttribute(h,e),o?Ba.addScaledVector(zh,u):Ba.addScaledVector(zh.sub(t),u))}t.add(Ba)}return t}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Ua.copy(n.boundingSphere),Ua.applyMatrix4(r),Bs.copy(e.ray).recast(e.near),!(Ua.containsPoint(Bs.origin)===!1&&(Bs.intersectSphere(Ua,vp)===null||Bs.origin.distanceToSquared(vp)>(e.far-e.near)**2))&&(xp.copy(r).invert(),Bs.copy(e.ray).applyMatrix4(xp),!(n.boundingBox!==null&&Bs.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Bs)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,M=f.length;_<M;_++){let m=f[_],p=o[m.materialIndex],E=Math.max(m.start,d.start),w=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let y=E,F=w;y<F;y+=3){let I=a.getX(y),L=a.getX(y+1),B=a.getX(y+2);s=za(this,p,e,n,c,u,h,I,L,B),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let _=Math.max(0,d.start),M=Math.min(a.count,d.start+d.count);for(let m=_,p=M;m<p;m+=3){let E=a.getX(m),w=a.getX(m+1),y=a.getX(m+2);s=za(this,o,e,n,c,u,h,E,w,y),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,M=f.length;_<M;_++){let m=f[_],p=o[m.materialIndex],E=Math.max(m.start,d.start),w=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let y=E,F=w;y<F;y+=3){let I=y,L=y+1,B=y+2;s=za(this,p,e,n,c,u,h,I,L,B),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let _=Math.max(0,d.start),M=Math.min(l.count,d.start+d.count);for(let m=_,p=M;m<p;m+=3){let E=m,w=m+1,y=m+2;s=za(this,o,e,n,c,u,h,E,w,y),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function $_(i,e,t,n,s,r,o,a){let l;if(e.side===Rn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===Wi,a),l===null)return null;ka.copy(a),ka.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(ka);return c<t.near||c>t.far?null:{distance:c,point:ka.clone(),object:i}}function za(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Fa),i.getVertexPosition(l,Na),i.getVertexPosition(c,Oa);let u=$_(i,e,t,n,Fa,Na,Oa,yp);if(u){let h=new J;ds.getBarycoord(yp,Fa,Na,Oa,h),s&&(u.uv=ds.getInterpolatedAttribute(s,a,l,c,h,new Tt)),r&&(u.uv1=ds.getInterpolatedAttribute(r,a,l,c,h,new Tt)),o&&(u.normal=ds.getInterpolatedAttribute(o,a,l,c,h,new J),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new J,materialIndex:0};ds.getNormal(Fa,Na,Oa,f.normal),u.face=f,u.barycoord=h}return u}var kr=class i extends ii{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;_("z","y","x",-1,-1,n,t,e,o,r,0),_("z","y","x",1,-1,n,t,-e,o,r,1),_("x","z","y",1,1,e,n,t,s,o,2),_("x","z","y",1,-1,e,n,-t,s,o,3),_("x","y","z",1,-1,e,t,n,s,r,4),_("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new bi(c,3)),this.setAttribute("normal",new bi(u,3)),this.setAttribute("uv",new bi(h,2));function _(M,m,p,E,w,y,F,I,L,B,T){let b=y/L,R=F/B,X=y/2,k=F/2,G=I/2,Y=L+1,q=B+1,K=0,j=0,ce=new J;for(let le=0;le<q;le++){let ge=le*R-k;for(let be=0;be<Y;be++){let pe=be*b-X;ce[M]=pe*E,ce[m]=ge*w,ce[p]=G,c.push(ce.x,ce.y,ce.z),ce[M]=0,ce[m]=0,ce[p]=I>0?1:-1,u.push(ce.x,ce.y,ce.z),h.push(be/L),h.push(1-le/B),K+=1}}for(let le=0;le<B;le++)for(let ge=0;ge<L;ge++){let be=f+ge+Y*le,pe=f+ge+Y*(le+1),Q=f+(ge+1)+Y*(le+1),he=f+(ge+1)+Y*le;l.push(be,pe,he),l.push(pe,Q,he),j+=6}a.addGroup(d,j,T),d+=j,f+=K}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};function Js(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone():Array.isArray(s)?e[t][n]=s.slice():e[t][n]=s}}return e}function vn(i){let e={};for(let t=0;t<i.length;t++){let n=Js(i[t]);for(let s in n)e[s]=n[s]}return e}function Z_(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function uu(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:ct.workingColorSpace}var gm={clone:Js,merge:vn},J_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,K_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,si=class extends qs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=J_,this.fragmentShader=K_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Js(e.uniforms),this.uniformsGroups=Z_(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}},Uo=class extends ni{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Kt,this.projectionMatrix=new Kt,this.projectionMatrixInverse=new Kt,this.coordinateSystem=Mi}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},fs=new J,Mp=new Tt,bp=new Tt,Dn=class extends Uo{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Za*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(vh*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Za*2*Math.atan(Math.tan(vh*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){fs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(fs.x,fs.y).multiplyScalar(-e/fs.z),fs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(fs.x,fs.y).multiplyScalar(-e/fs.z)}getViewSize(e,t){return this.getViewBounds(e,Mp,bp),t.subVectors(bp,Mp)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(vh*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},Dr=-90,Ur=1,el=class extends ni{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Dn(Dr,Ur,e,t);s.layers=this.layers,this.add(s);let r=new Dn(Dr,Ur,e,t);r.layers=this.layers,this.add(r);let o=new Dn(Dr,Ur,e,t);o.layers=this.layers,this.add(o);let a=new Dn(Dr,Ur,e,t);a.layers=this.layers,this.add(a);let l=new Dn(Dr,Ur,e,t);l.layers=this.layers,this.add(l);let c=new Dn(Dr,Ur,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Mi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Ao)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;let M=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,e.setRenderTarget(n,0,s),e.render(t,r),e.setRenderTarget(n,1,s),e.render(t,o),e.setRenderTarget(n,2,s),e.render(t,a),e.setRenderTarget(n,3,s),e.render(t,l),e.setRenderTarget(n,4,s),e.render(t,c),n.texture.generateMipmaps=M,e.setRenderTarget(n,5,s),e.render(t,u),e.setRenderTarget(h,f,d),e.xr.enabled=_,n.texture.needsPMREMUpdate=!0}},Fo=class extends Fn{constructor(e=[],t=$s,n,s,r,o,a,l,c,u){super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},tl=class extends Si{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Fo(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new kr(5,5,5),r=new si({name:"CubemapFromEquirect",uniforms:Js(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Rn,blending:Yi});r.uniforms.tEquirect.value=t;let o=new Cn(s,r),a=t.minFilter;return t.minFilter===vs&&(t.minFilter=Zn),new el(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Vs=class extends ni{constructor(){super(),this.isGroup=!0,this.type="Group"}},j_={type:"move"},zr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Vs,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Vs,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new J,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new J),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Vs,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new J,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new J),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let M of e.hand.values()){let m=t.getJointPose(M,n),p=this._getHandJoint(c,M);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,_=.005;c.inputState.pinching&&f>d+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(j_)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Vs;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}};var No=class extends ni{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new wi,this.environmentIntensity=1,this.environmentRotation=new wi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}};var Oo=class extends Fn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Un,u=Un,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Vr=class extends jt{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var Vh=new J,Q_=new J,ex=new et,yi=class{constructor(e=new J(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Vh.subVectors(n,t).cross(Q_.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){let n=e.delta(Vh),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(n,r)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||ex.getNormalMatrix(e),s=this.coplanarPoint(Vh).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}},ks=new Br,tx=new Tt(.5,.5),Va=new J,Bo=class{constructor(e=new yi,t=new yi,n=new yi,s=new yi,r=new yi,o=new yi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Mi){let n=this.planes,s=e.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],u=s[5],h=s[6],f=s[7],d=s[8],_=s[9],M=s[10],m=s[11],p=s[12],E=s[13],w=s[14],y=s[15];if(n[0].setComponents(l-r,f-c,m-d,y-p).normalize(),n[1].setComponents(l+r,f+c,m+d,y+p).normalize(),n[2].setComponents(l+o,f+u,m+_,y+E).normalize(),n[3].setComponents(l-o,f-u,m-_,y-E).normalize(),n[4].setComponents(l-a,f-h,m-M,y-w).normalize(),t===Mi)n[5].setComponents(l+a,f+h,m+M,y+w).normalize();else if(t===Ao)n[5].setComponents(a,h,M,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),ks.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),ks.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(ks)}intersectsSprite(e){ks.center.set(0,0,0);let t=tx.distanceTo(e.center);return ks.radius=.7071067811865476+t,ks.applyMatrix4(e.matrixWorld),this.intersectsSphere(ks)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Va.x=s.normal.x>0?e.max.x:e.min.x,Va.y=s.normal.y>0?e.max.y:e.min.y,Va.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Va)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var ko=class extends Fn{constructor(e,t,n=ys,s,r,o,a=Un,l=Un,c,u=Nr,h=1){if(u!==Nr&&u!==Yr)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Or(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}};var zo=class i extends ii{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,d=[],_=[],M=[],m=[];for(let p=0;p<u;p++){let E=p*f-o;for(let w=0;w<c;w++){let y=w*h-r;_.push(y,-E,0),M.push(0,0,1),m.push(w/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let E=0;E<a;E++){let w=E+c*p,y=E+c*(p+1),F=E+1+c*(p+1),I=E+1+c*p;d.push(w,y,I),d.push(y,F,I)}this.setIndex(d),this.setAttribute("position",new bi(_,3)),this.setAttribute("normal",new bi(M,3)),this.setAttribute("uv",new bi(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Hr=class extends si{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var nl=class extends qs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=em,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},il=class extends qs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ha(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function nx(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var Ys=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},sl=class extends Ys{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Hh,endingEnd:Hh}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Gh:r=e,a=2*t-n;break;case Wh:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Gh:o=e,l=2*n-t;break;case Wh:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,_=(n-t)/(s-t),M=_*_,m=M*_,p=-f*m+2*f*M-f*_,E=(1+f)*m+(-1.5-2*f)*M+(-.5+f)*_+1,w=(-1-d)*m+(1.5+d)*M+.5*_,y=d*m-d*M;for(let F=0;F!==a;++F)r[F]=p*o[u+F]+E*o[c+F]+w*o[l+F]+y*o[h+F];return r}},rl=class extends Ys{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},ol=class extends Ys{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Jn=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ha(t,this.TimeBufferType),this.values=Ha(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Ha(e.times,Array),values:Ha(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s)}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new ol(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new rl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new sl(this.times,this.values,this.getValueSize(),e)}setInterpolation(e){let t;switch(e){case To:t=this.InterpolantFactoryMethodDiscrete;break;case $a:t=this.InterpolantFactoryMethodLinear;break;case Ga:t=this.InterpolantFactoryMethodSmooth;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return To;case this.InterpolantFactoryMethodLinear:return $a;case this.InterpolantFactoryMethodSmooth:return Ga}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&nx(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Ga,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*n,f=h-n,d=h+n;for(let _=0;_!==n;++_){let M=t[h+_];if(M!==t[f+_]||M!==t[d+_]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*n,f=o*n;for(let d=0;d!==n;++d)t[f+d]=t[h+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,s}};Jn.prototype.ValueTypeName="";Jn.prototype.TimeBufferType=Float32Array;Jn.prototype.ValueBufferType=Float32Array;Jn.prototype.DefaultInterpolation=$a;var _s=class extends Jn{constructor(e,t,n){super(e,t,n)}};_s.prototype.ValueTypeName="bool";_s.prototype.ValueBufferType=Array;_s.prototype.DefaultInterpolation=To;_s.prototype.InterpolantFactoryMethodLinear=void 0;_s.prototype.InterpolantFactoryMethodSmooth=void 0;var al=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}};al.prototype.ValueTypeName="color";var ll=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}};ll.prototype.ValueTypeName="number";var cl=class extends Ys{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)qi.slerpFlat(r,0,o,c-a,o,c,l);return r}},Vo=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new cl(this.times,this.values,this.getValueSize(),e)}};Vo.prototype.ValueTypeName="quaternion";Vo.prototype.InterpolantFactoryMethodSmooth=void 0;var xs=class extends Jn{constructor(e,t,n){super(e,t,n)}};xs.prototype.ValueTypeName="string";xs.prototype.ValueBufferType=Array;xs.prototype.DefaultInterpolation=To;xs.prototype.InterpolantFactoryMethodLinear=void 0;xs.prototype.InterpolantFactoryMethodSmooth=void 0;var hl=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}};hl.prototype.ValueTypeName="vector";var ul=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],_=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return _}return null}}},_m=new ul,fl=class{constructor(e){this.manager=e!==void 0?e:_m,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}};fl.DEFAULT_MATERIAL_NAME="__DEFAULT";var Gr=class extends Uo{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Ho=class extends ii{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var dl=class extends Dn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}};var fu="\\[\\]\\.:\\/",ix=new RegExp("["+fu+"]","g"),du="[^"+fu+"]",sx="[^"+fu.replace("\\.","")+"]",rx=/((?:WC+[\/:])*)/.source.replace("WC",du),ox=/(WCOD+)?/.source.replace("WCOD",sx),ax=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",du),lx=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",du),cx=new RegExp("^"+rx+ox+ax+lx+"$"),hx=["material","materials","bones","map"],Yh=class{constructor(e,t,n){let s=n||Bt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Bt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(ix,"")}static parseTrackName(e){let t=cx.exec(e);if(t===null)throw new Error("PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);hx.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Bt.Composite=Yh;Bt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Bt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Bt.prototype.GetterByBindingType=[Bt.prototype._getValue_direct,Bt.prototype._getValue_array,Bt.prototype._getValue_arrayElement,Bt.prototype._getValue_toArray];Bt.prototype.SetterByBindingTypeAndVersioning=[[Bt.prototype._setValue_direct,Bt.prototype._setValue_direct_setNeedsUpdate,Bt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Bt.prototype._setValue_array,Bt.prototype._setValue_array_setNeedsUpdate,Bt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Bt.prototype._setValue_arrayElement,Bt.prototype._setValue_arrayElement_setNeedsUpdate,Bt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Bt.prototype._setValue_fromArray,Bt.prototype._setValue_fromArray_setNeedsUpdate,Bt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var AS=new Float32Array(1);function pu(i,e,t,n){let s=ux(n);switch(t){case su:return i*e;case ou:return i*e/s.components*s.byteLength;case Al:return i*e/s.components*s.byteLength;case au:return i*e*2/s.components*s.byteLength;case Cl:return i*e*2/s.components*s.byteLength;case ru:return i*e*3/s.components*s.byteLength;case Nn:return i*e*4/s.components*s.byteLength;case Rl:return i*e*4/s.components*s.byteLength;case Xo:case qo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Yo:case $o:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Il:case Dl:return Math.max(i,16)*Math.max(e,8)/4;case Pl:case Ll:return Math.max(i,8)*Math.max(e,8)/2;case Ul:case Fl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Nl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ol:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Bl:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case kl:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case zl:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Vl:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Hl:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Gl:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Wl:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Xl:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case ql:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Yl:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case $l:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Zl:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Jl:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Zo:case Kl:case jl:return Math.ceil(i/4)*Math.ceil(e/4)*16;case lu:case Ql:return Math.ceil(i/4)*Math.ceil(e/4)*8;case ec:case tc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function ux(i){switch(i){case Ai:case tu:return{byteLength:1,components:1};case Wr:case nu:case Xr:return{byteLength:2,components:1};case Tl:case El:return{byteLength:2,components:4};case ys:case wl:case Ci:return{byteLength:4,components:1};case iu:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"178"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="178");function Vm(){let i=null,e=!1,t=null,n=null;function s(r,o){t(r,o),n=i.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function dx(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((d,_)=>d.start-_.start);let f=0;for(let d=1;d<h.length;d++){let _=h[f],M=h[d];M.start<=_.start+_.count+1?_.count=Math.max(_.count,M.start+M.count-_.start):(++f,h[f]=M)}h.length=f+1;for(let d=0,_=h.length;d<_;d++){let M=h[d];i.bufferSubData(c,M.start*u.BYTES_PER_ELEMENT,u,M.start,M.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var px=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,mx=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,gx=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,_x=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,xx=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,vx=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,yx=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Mx=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,bx=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,Sx=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,wx=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Tx=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Ex=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Ax=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Cx=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Rx=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Px=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Ix=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Lx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Dx=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Ux=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Fx=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,Nx=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,Ox=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Bx=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,kx=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,zx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Vx=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Hx=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Gx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Wx="gl_FragColor = linearToOutputTexel( gl_FragColor );",Xx=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,qx=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,Yx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,$x=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Zx=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Jx=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Kx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,jx=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Qx=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,ev=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,tv=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,nv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,iv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,sv=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,rv=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,ov=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,av=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,lv=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,cv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,hv=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,uv=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,fv=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,dv=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,pv=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,mv=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,gv=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,_v=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,xv=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,vv=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,yv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Mv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,bv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Sv=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,wv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Tv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Ev=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Av=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Cv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Rv=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Pv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Iv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Lv=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Dv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Uv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Fv=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,Nv=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Ov=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Bv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,kv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,zv=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Vv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Hv=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,Gv=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Wv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Xv=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,qv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Yv=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,$v=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Zv=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,Jv=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Kv=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,jv=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Qv=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,ey=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,ty=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,ny=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,iy=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,sy=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ry=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,oy=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,ay=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,ly=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,cy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,hy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,uy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,fy=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,dy=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,py=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,my=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,gy=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,_y=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,xy=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,vy=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,yy=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,My=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,by=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,Sy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,wy=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ty=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Ey=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ay=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Cy=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ry=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Py=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Iy=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Ly=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Dy=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Uy=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Fy=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Ny=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Oy=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,By=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ky=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,zy=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Vy=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Hy=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Gy=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Wy=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Xy=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,qy=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,st={alphahash_fragment:px,alphahash_pars_fragment:mx,alphamap_fragment:gx,alphamap_pars_fragment:_x,alphatest_fragment:xx,alphatest_pars_fragment:vx,aomap_fragment:yx,aomap_pars_fragment:Mx,batching_pars_vertex:bx,batching_vertex:Sx,begin_vertex:wx,beginnormal_vertex:Tx,bsdfs:Ex,iridescence_fragment:Ax,bumpmap_pars_fragment:Cx,clipping_planes_fragment:Rx,clipping_planes_pars_fragment:Px,clipping_planes_pars_vertex:Ix,clipping_planes_vertex:Lx,color_fragment:Dx,color_pars_fragment:Ux,color_pars_vertex:Fx,color_vertex:Nx,common:Ox,cube_uv_reflection_fragment:Bx,defaultnormal_vertex:kx,displacementmap_pars_vertex:zx,displacementmap_vertex:Vx,emissivemap_fragment:Hx,emissivemap_pars_fragment:Gx,colorspace_fragment:Wx,colorspace_pars_fragment:Xx,envmap_fragment:qx,envmap_common_pars_fragment:Yx,envmap_pars_fragment:$x,envmap_pars_vertex:Zx,envmap_physical_pars_fragment:ov,envmap_vertex:Jx,fog_vertex:Kx,fog_pars_vertex:jx,fog_fragment:Qx,fog_pars_fragment:ev,gradientmap_pars_fragment:tv,lightmap_pars_fragment:nv,lights_lambert_fragment:iv,lights_lambert_pars_fragment:sv,lights_pars_begin:rv,lights_toon_fragment:av,lights_toon_pars_fragment:lv,lights_phong_fragment:cv,lights_phong_pars_fragment:hv,lights_physical_fragment:uv,lights_physical_pars_fragment:fv,lights_fragment_begin:dv,lights_fragment_maps:pv,lights_fragment_end:mv,logdepthbuf_fragment:gv,logdepthbuf_pars_fragment:_v,logdepthbuf_pars_vertex:xv,logdepthbuf_vertex:vv,map_fragment:yv,map_pars_fragment:Mv,map_particle_fragment:bv,map_particle_pars_fragment:Sv,metalnessmap_fragment:wv,metalnessmap_pars_fragment:Tv,morphinstance_vertex:Ev,morphcolor_vertex:Av,morphnormal_vertex:Cv,morphtarget_pars_vertex:Rv,morphtarget_vertex:Pv,normal_fragment_begin:Iv,normal_fragment_maps:Lv,normal_pars_fragment:Dv,normal_pars_vertex:Uv,normal_vertex:Fv,normalmap_pars_fragment:Nv,clearcoat_normal_fragment_begin:Ov,clearcoat_normal_fragment_maps:Bv,clearcoat_pars_fragment:kv,iridescence_pars_fragment:zv,opaque_fragment:Vv,packing:Hv,premultiplied_alpha_fragment:Gv,project_vertex:Wv,dithering_fragment:Xv,dithering_pars_fragment:qv,roughnessmap_fragment:Yv,roughnessmap_pars_fragment:$v,shadowmap_pars_fragment:Zv,shadowmap_pars_vertex:Jv,shadowmap_vertex:Kv,shadowmask_pars_fragment:jv,skinbase_vertex:Qv,skinning_pars_vertex:ey,skinning_vertex:ty,skinnormal_vertex:ny,specularmap_fragment:iy,specularmap_pars_fragment:sy,tonemapping_fragment:ry,tonemapping_pars_fragment:oy,transmission_fragment:ay,transmission_pars_fragment:ly,uv_pars_fragment:cy,uv_pars_vertex:hy,uv_vertex:uy,worldpos_vertex:fy,background_vert:dy,background_frag:py,backgroundCube_vert:my,backgroundCube_frag:gy,cube_vert:_y,cube_frag:xy,depth_vert:vy,depth_frag:yy,distanceRGBA_vert:My,distanceRGBA_frag:by,equirect_vert:Sy,equirect_frag:wy,linedashed_vert:Ty,linedashed_frag:Ey,meshbasic_vert:Ay,meshbasic_frag:Cy,meshlambert_vert:Ry,meshlambert_frag:Py,meshmatcap_vert:Iy,meshmatcap_frag:Ly,meshnormal_vert:Dy,meshnormal_frag:Uy,meshphong_vert:Fy,meshphong_frag:Ny,meshphysical_vert:Oy,meshphysical_frag:By,meshtoon_vert:ky,meshtoon_frag:zy,points_vert:Vy,points_frag:Hy,shadow_vert:Gy,shadow_frag:Wy,sprite_vert:Xy,sprite_frag:qy},Se={common:{diffuse:{value:new yt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new Tt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new yt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new yt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new yt(16777215)},opacity:{value:1},center:{value:new Tt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}},Ri={basic:{uniforms:vn([Se.common,Se.specularmap,Se.envmap,Se.aomap,Se.lightmap,Se.fog]),vertexShader:st.meshbasic_vert,fragmentShader:st.meshbasic_frag},lambert:{uniforms:vn([Se.common,Se.specularmap,Se.envmap,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.fog,Se.lights,{emissive:{value:new yt(0)}}]),vertexShader:st.meshlambert_vert,fragmentShader:st.meshlambert_frag},phong:{uniforms:vn([Se.common,Se.specularmap,Se.envmap,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.fog,Se.lights,{emissive:{value:new yt(0)},specular:{value:new yt(1118481)},shininess:{value:30}}]),vertexShader:st.meshphong_vert,fragmentShader:st.meshphong_frag},standard:{uniforms:vn([Se.common,Se.envmap,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.roughnessmap,Se.metalnessmap,Se.fog,Se.lights,{emissive:{value:new yt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:st.meshphysical_vert,fragmentShader:st.meshphysical_frag},toon:{uniforms:vn([Se.common,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.gradientmap,Se.fog,Se.lights,{emissive:{value:new yt(0)}}]),vertexShader:st.meshtoon_vert,fragmentShader:st.meshtoon_frag},matcap:{uniforms:vn([Se.common,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.fog,{matcap:{value:null}}]),vertexShader:st.meshmatcap_vert,fragmentShader:st.meshmatcap_frag},points:{uniforms:vn([Se.points,Se.fog]),vertexShader:st.points_vert,fragmentShader:st.points_frag},dashed:{uniforms:vn([Se.common,Se.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:st.linedashed_vert,fragmentShader:st.linedashed_frag},depth:{uniforms:vn([Se.common,Se.displacementmap]),vertexShader:st.depth_vert,fragmentShader:st.depth_frag},normal:{uniforms:vn([Se.common,Se.bumpmap,Se.normalmap,Se.displacementmap,{opacity:{value:1}}]),vertexShader:st.meshnormal_vert,fragmentShader:st.meshnormal_frag},sprite:{uniforms:vn([Se.sprite,Se.fog]),vertexShader:st.sprite_vert,fragmentShader:st.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:st.background_vert,fragmentShader:st.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:st.backgroundCube_vert,fragmentShader:st.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:st.cube_vert,fragmentShader:st.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:st.equirect_vert,fragmentShader:st.equirect_frag},distanceRGBA:{uniforms:vn([Se.common,Se.displacementmap,{referencePosition:{value:new J},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:st.distanceRGBA_vert,fragmentShader:st.distanceRGBA_frag},shadow:{uniforms:vn([Se.lights,Se.fog,{color:{value:new yt(0)},opacity:{value:1}}]),vertexShader:st.shadow_vert,fragmentShader:st.shadow_frag}};Ri.physical={uniforms:vn([Ri.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new Tt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new yt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new Tt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new yt(0)},specularColor:{value:new yt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new Tt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:st.meshphysical_vert,fragmentShader:st.meshphysical_frag};var nc={r:0,b:0,g:0},Ks=new wi,Yy=new Kt;function $y(i,e,t,n,s,r,o){let a=new yt(0),l=r===!0?0:1,c,u,h=null,f=0,d=null;function _(w){let y=w.isScene===!0?w.background:null;return y&&y.isTexture&&(y=(w.backgroundBlurriness>0?t:e).get(y)),y}function M(w){let y=!1,F=_(w);F===null?p(a,l):F&&F.isColor&&(p(F,1),y=!0);let I=i.xr.getEnvironmentBlendMode();I==="additive"?n.buffers.color.setClear(0,0,0,1,o):I==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||y)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(w,y){let F=_(y);F&&(F.isCubeTexture||F.mapping===Go)?(u===void 0&&(u=new Cn(new kr(1,1,1),new si({name:"BackgroundCubeMaterial",uniforms:Js(Ri.backgroundCube.uniforms),vertexShader:Ri.backgroundCube.vertexShader,fragmentShader:Ri.backgroundCube.fragmentShader,side:Rn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(I,L,B){this.matrixWorld.copyPosition(B.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),Ks.copy(y.backgroundRotation),Ks.x*=-1,Ks.y*=-1,Ks.z*=-1,F.isCubeTexture&&F.isRenderTargetTexture===!1&&(Ks.y*=-1,Ks.z*=-1),u.material.uniforms.envMap.value=F,u.material.uniforms.flipEnvMap.value=F.isCubeTexture&&F.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=y.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=y.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(Yy.makeRotationFromEuler(Ks)),u.material.toneMapped=ct.getTransfer(F.colorSpace)!==wt,(h!==F||f!==F.version||d!==i.toneMapping)&&(u.material.needsUpdate=!0,h=F,f=F.version,d=i.toneMapping),u.layers.enableAll(),w.unshift(u,u.geometry,u.material,0,0,null)):F&&F.isTexture&&(c===void 0&&(c=new Cn(new zo(2,2),new si({name:"BackgroundMaterial",uniforms:Js(Ri.background.uniforms),vertexShader:Ri.background.vertexShader,fragmentShader:Ri.background.fragmentShader,side:Wi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=F,c.material.uniforms.backgroundIntensity.value=y.backgroundIntensity,c.material.toneMapped=ct.getTransfer(F.colorSpace)!==wt,F.matrixAutoUpdate===!0&&F.updateMatrix(),c.material.uniforms.uvTransform.value.copy(F.matrix),(h!==F||f!==F.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=F,f=F.version,d=i.toneMapping),c.layers.enableAll(),w.unshift(c,c.geometry,c.material,0,0,null))}function p(w,y){w.getRGB(nc,uu(i)),n.buffers.color.setClear(nc.r,nc.g,nc.b,y,o)}function E(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(w,y=1){a.set(w),l=y,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(w){l=w,p(a,l)},render:M,addToRenderList:m,dispose:E}}function Zy(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(b,R,X,k,G){let Y=!1,q=h(k,X,R);r!==q&&(r=q,c(r.object)),Y=d(b,k,X,G),Y&&_(b,k,X,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,y(b,R,X,k),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return i.createVertexArray()}function c(b){return i.bindVertexArray(b)}function u(b){return i.deleteVertexArray(b)}function h(b,R,X){let k=X.wireframe===!0,G=n[b.id];G===void 0&&(G={},n[b.id]=G);let Y=G[R.id];Y===void 0&&(Y={},G[R.id]=Y);let q=Y[k];return q===void 0&&(q=f(l()),Y[k]=q),q}function f(b){let R=[],X=[],k=[];for(let G=0;G<t;G++)R[G]=0,X[G]=0,k[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:R,enabledAttributes:X,attributeDivisors:k,object:b,attributes:{},index:null}}function d(b,R,X,k){let G=r.attributes,Y=R.attributes,q=0,K=X.getAttributes();for(let j in K)if(K[j].location>=0){let le=G[j],ge=Y[j];if(ge===void 0&&(j==="instanceMatrix"&&b.instanceMatrix&&(ge=b.instanceMatrix),j==="instanceColor"&&b.instanceColor&&(ge=b.instanceColor)),le===void 0||le.attribute!==ge||ge&&le.data!==ge.data)return!0;q++}return r.attributesNum!==q||r.index!==k}function _(b,R,X,k){let G={},Y=R.attributes,q=0,K=X.getAttributes();for(let j in K)if(K[j].location>=0){let le=Y[j];le===void 0&&(j==="instanceMatrix"&&b.instanceMatrix&&(le=b.instanceMatrix),j==="instanceColor"&&b.instanceColor&&(le=b.instanceColor));let ge={};ge.attribute=le,le&&le.data&&(ge.data=le.data),G[j]=ge,q++}r.attributes=G,r.attributesNum=q,r.index=k}function M(){let b=r.newAttributes;for(let R=0,X=b.length;R<X;R++)b[R]=0}function m(b){p(b,0)}function p(b,R){let X=r.newAttributes,k=r.enabledAttributes,G=r.attributeDivisors;X[b]=1,k[b]===0&&(i.enableVertexAttribArray(b),k[b]=1),G[b]!==R&&(i.vertexAttribDivisor(b,R),G[b]=R)}function E(){let b=r.newAttributes,R=r.enabledAttributes;for(let X=0,k=R.length;X<k;X++)R[X]!==b[X]&&(i.disableVertexAttribArray(X),R[X]=0)}function w(b,R,X,k,G,Y,q){q===!0?i.vertexAttribIPointer(b,R,X,G,Y):i.vertexAttribPointer(b,R,X,k,G,Y)}function y(b,R,X,k){M();let G=k.attributes,Y=X.getAttributes(),q=R.defaultAttributeValues;for(let K in Y){let j=Y[K];if(j.location>=0){let ce=G[K];if(ce===void 0&&(K==="instanceMatrix"&&b.instanceMatrix&&(ce=b.instanceMatrix),K==="instanceColor"&&b.instanceColor&&(ce=b.instanceColor)),ce!==void 0){let le=ce.normalized,ge=ce.itemSize,be=e.get(ce);if(be===void 0)continue;let pe=be.buffer,Q=be.type,he=be.bytesPerElement,_e=Q===i.INT||Q===i.UNSIGNED_INT||ce.gpuType===wl;if(ce.isInterleavedBufferAttribute){let oe=ce.data,De=oe.stride,Je=ce.offset;if(oe.isInstancedInterleavedBuffer){for(let Te=0;Te<j.locationSize;Te++)p(j.location+Te,oe.meshPerAttribute);b.isInstancedMesh!==!0&&k._maxInstanceCount===void 0&&(k._maxInstanceCount=oe.meshPerAttribute*oe.count)}else for(let Te=0;Te<j.locationSize;Te++)m(j.location+Te);i.bindBuffer(i.ARRAY_BUFFER,pe);for(let Te=0;Te<j.locationSize;Te++)w(j.location+Te,ge/j.locationSize,Q,le,De*he,(Je+ge/j.locationSize*Te)*he,_e)}else{if(ce.isInstancedBufferAttribute){for(let oe=0;oe<j.locationSize;oe++)p(j.location+oe,ce.meshPerAttribute);b.isInstancedMesh!==!0&&k._maxInstanceCount===void 0&&(k._maxInstanceCount=ce.meshPerAttribute*ce.count)}else for(let oe=0;oe<j.locationSize;oe++)m(j.location+oe);i.bindBuffer(i.ARRAY_BUFFER,pe);for(let oe=0;oe<j.locationSize;oe++)w(j.location+oe,ge/j.locationSize,Q,le,ge*he,ge/j.locationSize*oe*he,_e)}}else if(q!==void 0){let le=q[K];if(le!==void 0)switch(le.length){case 2:i.vertexAttrib2fv(j.location,le);break;case 3:i.vertexAttrib3fv(j.location,le);break;case 4:i.vertexAttrib4fv(j.location,le);break;default:i.vertexAttrib1fv(j.location,le)}}}}E()}function F(){B();for(let b in n){let R=n[b];for(let X in R){let k=R[X];for(let G in k)u(k[G].object),delete k[G];delete R[X]}delete n[b]}}function I(b){if(n[b.id]===void 0)return;let R=n[b.id];for(let X in R){let k=R[X];for(let G in k)u(k[G].object),delete k[G];delete R[X]}delete n[b.id]}function L(b){for(let R in n){let X=n[R];if(X[b.id]===void 0)continue;let k=X[b.id];for(let G in k)u(k[G].object),delete k[G];delete X[b.id]}}function B(){T(),o=!0,r!==s&&(r=s,c(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:T,dispose:F,releaseStatesOfGeometry:I,releaseStatesOfProgram:L,initAttributes:M,enableAttribute:m,disableUnusedAttributes:E}}function Jy(i,e,t){let n;function s(c){n=c}function r(c,u){i.drawArrays(n,c,u),t.update(u,n,1)}function o(c,u,h){h!==0&&(i.drawArraysInstanced(n,c,u,h),t.update(u,n,h))}function a(c,u,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,u,0,h);let d=0;for(let _=0;_<h;_++)d+=u[_];t.update(d,n,1)}function l(c,u,h,f){if(h===0)return;let d=e.get("WEBGL_multi_draw");if(d===null)for(let _=0;_<c.length;_++)o(c[_],u[_],f[_]);else{d.multiDrawArraysInstancedWEBGL(n,c,0,u,0,f,0,h);let _=0;for(let M=0;M<h;M++)_+=u[M]*f[M];t.update(_,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function Ky(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let L=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(L.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(L){return!(L!==Nn&&n.convert(L)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(L){let B=L===Xr&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(L!==Ai&&n.convert(L)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&L!==Ci&&!B)}function l(L){if(L==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";L="mediump"}return L==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.logarithmicDepthBuffer===!0,f=t.reverseDepthBuffer===!0&&e.has("EXT_clip_control"),d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),M=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),E=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),w=i.getParameter(i.MAX_VARYING_VECTORS),y=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),F=_>0,I=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reverseDepthBuffer:f,maxTextures:d,maxVertexTextures:_,maxTextureSize:M,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:E,maxVaryings:w,maxFragmentUniforms:y,vertexTextures:F,maxSamples:I}}function jy(i){let e=this,t=null,n=0,s=!1,r=!1,o=new yi,a=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||n!==0||s;return s=f,n=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,d){let _=h.clippingPlanes,M=h.clipIntersection,m=h.clipShadows,p=i.get(h);if(!s||_===null||_.length===0||r&&!m)r?u(null):c();else{let E=r?0:n,w=E*4,y=p.clippingState||null;l.value=y,y=u(_,f,w,d);for(let F=0;F!==w;++F)y[F]=t[F];p.clippingState=y,this.numIntersection=M?this.numPlanes:0,this.numPlanes+=E}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,f,d,_){let M=h!==null?h.length:0,m=null;if(M!==0){if(m=l.value,_!==!0||m===null){let p=d+M*4,E=f.matrixWorldInverse;a.getNormalMatrix(E),(m===null||m.length<p)&&(m=new Float32Array(p));for(let w=0,y=d;w!==M;++w,y+=4)o.copy(h[w]).applyMatrix4(E,a),o.normal.toArray(m,y),m[y+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=M,e.numIntersection=0,m}}function Qy(i){let e=new WeakMap;function t(o,a){return a===Ml?o.mapping=$s:a===bl&&(o.mapping=Zs),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===Ml||a===bl)if(e.has(o)){let l=e.get(o).texture;return t(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new tl(l.height);return c.fromEquirectangularTexture(i,o),e.set(o,c),o.addEventListener("dispose",s),t(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function r(){e=new WeakMap}return{get:n,dispose:r}}var Jr=4,xm=[.125,.215,.35,.446,.526,.582],er=20,mu=new Gr,vm=new yt,gu=null,_u=0,xu=0,vu=!1,Qs=(1+Math.sqrt(5))/2,Zr=1/Qs,ym=[new J(-Qs,Zr,0),new J(Qs,Zr,0),new J(-Zr,0,Qs),new J(Zr,0,Qs),new J(0,Qs,-Zr),new J(0,Qs,Zr),new J(-1,1,-1),new J(1,1,-1),new J(-1,1,1),new J(1,1,1)],eM=new J,rc=class{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=eM}=r;gu=this._renderer.getRenderTarget(),_u=this._renderer.getActiveCubeFace(),xu=this._renderer.getActiveMipmapLevel(),vu=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,n,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Sm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=bm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(gu,_u,xu),this._renderer.xr.enabled=vu,e.scissorTest=!1,ic(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===$s||e.mapping===Zs?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),gu=this._renderer.getRenderTarget(),_u=this._renderer.getActiveCubeFace(),xu=this._renderer.getActiveMipmapLevel(),vu=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=t||this._allocateTargets();return this._textureToCubeUV(e,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,n={magFilter:Zn,minFilter:Zn,generateMipmaps:!1,type:Xr,format:Nn,colorSpace:Ws,depthBuffer:!1},s=Mm(e,t,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Mm(e,t,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=tM(r)),this._blurMaterial=nM(r,e,t)}return s}_compileMaterial(e){let t=new Cn(this._lodPlanes[0],e);this._renderer.compile(t,mu)}_sceneToCubeUV(e,t,n,s,r){let l=new Dn(90,1,t,n),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,f=h.autoClear,d=h.toneMapping;h.getClearColor(vm),h.toneMapping=$i,h.autoClear=!1;let _=new Io({name:"PMREM.Background",side:Rn,depthWrite:!1,depthTest:!1}),M=new Cn(new kr,_),m=!1,p=e.background;p?p.isColor&&(_.color.copy(p),e.background=null,m=!0):(_.color.copy(vm),m=!0);for(let E=0;E<6;E++){let w=E%3;w===0?(l.up.set(0,c[E],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[E],r.y,r.z)):w===1?(l.up.set(0,0,c[E]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[E],r.z)):(l.up.set(0,c[E],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[E]));let y=this._cubeSize;ic(s,w*y,E>2?y:0,y,y),h.setRenderTarget(s),m&&h.render(M,l),h.render(e,l)}M.geometry.dispose(),M.material.dispose(),h.toneMapping=d,h.autoClear=f,e.background=p}_textureToCubeUV(e,t){let n=this._renderer,s=e.mapping===$s||e.mapping===Zs;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=Sm()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=bm());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new Cn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;let l=this._cubeSize;ic(t,0,0,3*l,2*l),n.setRenderTarget(t),n.render(o,mu)}_applyPMREM(e){let t=this._renderer,n=t.autoClear;t.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=ym[(s-r-1)%ym.length];this._blur(e,r-1,r,o,a)}t.autoClear=n}_blur(e,t,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(e,o,t,n,s,"latitudinal",r),this._halfBlur(o,e,n,n,s,"longitudinal",r)}_halfBlur(e,t,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let u=3,h=new Cn(this._lodPlanes[s],c),f=c.uniforms,d=this._sizeLods[n]-1,_=isFinite(r)?Math.PI/(2*d):2*Math.PI/(2*er-1),M=r/_,m=isFinite(r)?1+Math.floor(u*M):er;m>er&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${er}`);let p=[],E=0;for(let L=0;L<er;++L){let B=L/M,T=Math.exp(-B*B/2);p.push(T),L===0?E+=T:L<m&&(E+=2*T)}for(let L=0;L<p.length;L++)p[L]=p[L]/E;f.envMap.value=e.texture,f.samples.value=m,f.weights.value=p,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:w}=this;f.dTheta.value=_,f.mipInt.value=w-n;let y=this._sizeLods[s],F=3*y*(s>w-Jr?s-w+Jr:0),I=4*(this._cubeSize-y);ic(t,F,I,3*y,2*y),l.setRenderTarget(t),l.render(h,mu)}};function tM(i){let e=[],t=[],n=[],s=i,r=i-Jr+1+xm.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);t.push(a);let l=1/a;o>i-Jr?l=xm[o-i+Jr-1]:o===0&&(l=0),n.push(l);let c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],d=6,_=6,M=3,m=2,p=1,E=new Float32Array(M*_*d),w=new Float32Array(m*_*d),y=new Float32Array(p*_*d);for(let I=0;I<d;I++){let L=I%3*2/3-1,B=I>2?0:-1,T=[L,B,0,L+2/3,B,0,L+2/3,B+1,0,L,B,0,L+2/3,B+1,0,L,B+1,0];E.set(T,M*_*I),w.set(f,m*_*I);let b=[I,I,I,I,I,I];y.set(b,p*_*I)}let F=new ii;F.setAttribute("position",new jt(E,M)),F.setAttribute("uv",new jt(w,m)),F.setAttribute("faceIndex",new jt(y,p)),e.push(F),s>Jr&&s--}return{lodPlanes:e,sizeLods:t,sigmas:n}}function Mm(i,e,t){let n=new Si(i,e,t);return n.texture.mapping=Go,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function ic(i,e,t,n,s){i.viewport.set(e,t,n,s),i.scissor.set(e,t,n,s)}function nM(i,e,t){let n=new Float32Array(er),s=new J(0,1,0);return new si({name:"SphericalGaussianBlur",defines:{n:er,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Ru(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:Yi,depthTest:!1,depthWrite:!1})}function bm(){return new si({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Ru(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:Yi,depthTest:!1,depthWrite:!1})}function Sm(){return new si({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Ru(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:Yi,depthTest:!1,depthWrite:!1})}function Ru(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function iM(i){let e=new WeakMap,t=null;function n(a){if(a&&a.isTexture){let l=a.mapping,c=l===Ml||l===bl,u=l===$s||l===Zs;if(c||u){let h=e.get(a),f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return t===null&&(t=new rc(i)),h=c?t.fromEquirectangular(a,h):t.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),h.texture;if(h!==void 0)return h.texture;{let d=a.image;return c&&d&&d.height>0||u&&d&&s(d)?(t===null&&(t=new rc(i)),h=c?t.fromEquirectangular(a):t.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0,c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:n,dispose:o}}function sM(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Xs("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function rM(i,e,t,n){let s={},r=new WeakMap;function o(h){let f=h.target;f.index!==null&&e.remove(f.index);for(let _ in f.attributes)e.remove(f.attributes[_]);f.removeEventListener("dispose",o),delete s[f.id];let d=r.get(f);d&&(e.remove(d),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,t.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,t.memory.geometries++),f}function l(h){let f=h.attributes;for(let d in f)e.update(f[d],i.ARRAY_BUFFER)}function c(h){let f=[],d=h.index,_=h.attributes.position,M=0;if(d!==null){let E=d.array;M=d.version;for(let w=0,y=E.length;w<y;w+=3){let F=E[w+0],I=E[w+1],L=E[w+2];f.push(F,I,I,L,L,F)}}else if(_!==void 0){let E=_.array;M=_.version;for(let w=0,y=E.length/3-1;w<y;w+=3){let F=w+0,I=w+1,L=w+2;f.push(F,I,I,L,L,F)}}else return;let m=new(hu(f)?Do:Lo)(f,1);m.version=M;let p=r.get(h);p&&e.remove(p),r.set(h,m)}function u(h){let f=r.get(h);if(f){let d=h.index;d!==null&&f.version<d.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function oM(i,e,t){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,d){i.drawElements(n,d,r,f*o),t.update(d,n,1)}function c(f,d,_){_!==0&&(i.drawElementsInstanced(n,d,r,f*o,_),t.update(d,n,_))}function u(f,d,_){if(_===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,f,0,_);let m=0;for(let p=0;p<_;p++)m+=d[p];t.update(m,n,1)}function h(f,d,_,M){if(_===0)return;let m=e.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<f.length;p++)c(f[p]/o,d[p],M[p]);else{m.multiDrawElementsInstancedWEBGL(n,d,0,r,f,0,M,0,_);let p=0;for(let E=0;E<_;E++)p+=d[E]*M[E];t.update(p,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function aM(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function lM(i,e,t){let n=new WeakMap,s=new zt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let T=function(){L.dispose(),n.delete(a),a.removeEventListener("dispose",T)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,M=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],E=a.morphAttributes.color||[],w=0;d===!0&&(w=1),_===!0&&(w=2),M===!0&&(w=3);let y=a.attributes.position.count*w,F=1;y>e.maxTextureSize&&(F=Math.ceil(y/e.maxTextureSize),y=e.maxTextureSize);let I=new Float32Array(y*F*4*h),L=new Ro(I,y,F,h);L.type=Ci,L.needsUpdate=!0;let B=w*4;for(let b=0;b<h;b++){let R=m[b],X=p[b],k=E[b],G=y*F*4*b;for(let Y=0;Y<R.count;Y++){let q=Y*B;d===!0&&(s.fromBufferAttribute(R,Y),I[G+q+0]=s.x,I[G+q+1]=s.y,I[G+q+2]=s.z,I[G+q+3]=0),_===!0&&(s.fromBufferAttribute(X,Y),I[G+q+4]=s.x,I[G+q+5]=s.y,I[G+q+6]=s.z,I[G+q+7]=0),M===!0&&(s.fromBufferAttribute(k,Y),I[G+q+8]=s.x,I[G+q+9]=s.y,I[G+q+10]=s.z,I[G+q+11]=k.itemSize===4?s.w:1)}}f={count:h,texture:L,size:new Tt(y,F)},n.set(a,f),a.addEventListener("dispose",T)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let d=0;for(let M=0;M<c.length;M++)d+=c[M];let _=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",_),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function cM(i,e,t,n){let s=new WeakMap;function r(l){let c=n.render.frame,u=l.geometry,h=e.get(l,u);if(s.get(h)!==c&&(e.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:o}}var Hm=new Fn,wm=new ko(1,1),Gm=new Ro,Wm=new ja,Xm=new Fo,Tm=[],Em=[],Am=new Float32Array(16),Cm=new Float32Array(9),Rm=new Float32Array(4);function jr(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=Tm[s];if(r===void 0&&(r=new Float32Array(s),Tm[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function on(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function an(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function ac(i,e){let t=Em[e];t===void 0&&(t=new Int32Array(e),Em[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function hM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function uM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(on(t,e))return;i.uniform2fv(this.addr,e),an(t,e)}}function fM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(on(t,e))return;i.uniform3fv(this.addr,e),an(t,e)}}function dM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(on(t,e))return;i.uniform4fv(this.addr,e),an(t,e)}}function pM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(on(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),an(t,e)}else{if(on(t,n))return;Rm.set(n),i.uniformMatrix2fv(this.addr,!1,Rm),an(t,n)}}function mM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(on(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),an(t,e)}else{if(on(t,n))return;Cm.set(n),i.uniformMatrix3fv(this.addr,!1,Cm),an(t,n)}}function gM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(on(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),an(t,e)}else{if(on(t,n))return;Am.set(n),i.uniformMatrix4fv(this.addr,!1,Am),an(t,n)}}function _M(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function xM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(on(t,e))return;i.uniform2iv(this.addr,e),an(t,e)}}function vM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(on(t,e))return;i.uniform3iv(this.addr,e),an(t,e)}}function yM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(on(t,e))return;i.uniform4iv(this.addr,e),an(t,e)}}function MM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function bM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(on(t,e))return;i.uniform2uiv(this.addr,e),an(t,e)}}function SM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(on(t,e))return;i.uniform3uiv(this.addr,e),an(t,e)}}function wM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(on(t,e))return;i.uniform4uiv(this.addr,e),an(t,e)}}function TM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(wm.compareFunction=cu,r=wm):r=Hm,t.setTexture2D(e||r,s)}function EM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Wm,s)}function AM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTextureCube(e||Xm,s)}function CM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Gm,s)}function RM(i){switch(i){case 5126:return hM;case 35664:return uM;case 35665:return fM;case 35666:return dM;case 35674:return pM;case 35675:return mM;case 35676:return gM;case 5124:case 35670:return _M;case 35667:case 35671:return xM;case 35668:case 35672:return vM;case 35669:case 35673:return yM;case 5125:return MM;case 36294:return bM;case 36295:return SM;case 36296:return wM;case 35678:case 36198:case 36298:case 36306:case 35682:return TM;case 35679:case 36299:case 36307:return EM;case 35680:case 36300:case 36308:case 36293:return AM;case 36289:case 36303:case 36311:case 36292:return CM}}function PM(i,e){i.uniform1fv(this.addr,e)}function IM(i,e){let t=jr(e,this.size,2);i.uniform2fv(this.addr,t)}function LM(i,e){let t=jr(e,this.size,3);i.uniform3fv(this.addr,t)}function DM(i,e){let t=jr(e,this.size,4);i.uniform4fv(this.addr,t)}function UM(i,e){let t=jr(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function FM(i,e){let t=jr(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function NM(i,e){let t=jr(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function OM(i,e){i.uniform1iv(this.addr,e)}function BM(i,e){i.uniform2iv(this.addr,e)}function kM(i,e){i.uniform3iv(this.addr,e)}function zM(i,e){i.uniform4iv(this.addr,e)}function VM(i,e){i.uniform1uiv(this.addr,e)}function HM(i,e){i.uniform2uiv(this.addr,e)}function GM(i,e){i.uniform3uiv(this.addr,e)}function WM(i,e){i.uniform4uiv(this.addr,e)}function XM(i,e,t){let n=this.cache,s=e.length,r=ac(t,s);on(n,r)||(i.uniform1iv(this.addr,r),an(n,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||Hm,r[o])}function qM(i,e,t){let n=this.cache,s=e.length,r=ac(t,s);on(n,r)||(i.uniform1iv(this.addr,r),an(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Wm,r[o])}function YM(i,e,t){let n=this.cache,s=e.length,r=ac(t,s);on(n,r)||(i.uniform1iv(this.addr,r),an(n,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||Xm,r[o])}function $M(i,e,t){let n=this.cache,s=e.length,r=ac(t,s);on(n,r)||(i.uniform1iv(this.addr,r),an(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Gm,r[o])}function ZM(i){switch(i){case 5126:return PM;case 35664:return IM;case 35665:return LM;case 35666:return DM;case 35674:return UM;case 35675:return FM;case 35676:return NM;case 5124:case 35670:return OM;case 35667:case 35671:return BM;case 35668:case 35672:return kM;case 35669:case 35673:return zM;case 5125:return VM;case 36294:return HM;case 36295:return GM;case 36296:return WM;case 35678:case 36198:case 36298:case 36306:case 35682:return XM;case 35679:case 36299:case 36307:return qM;case 35680:case 36300:case 36308:case 36293:return YM;case 36289:case 36303:case 36311:case 36292:return $M}}var Mu=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=RM(t.type)}},bu=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=ZM(t.type)}},Su=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},yu=/(\w+)(\])?(\[|\.)?/g;function Pm(i,e){i.seq.push(e),i.map[e.id]=e}function JM(i,e,t){let n=i.name,s=n.length;for(yu.lastIndex=0;;){let r=yu.exec(n),o=yu.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Pm(t,c===void 0?new Mu(a,i,e):new bu(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new Su(a),Pm(t,h)),t=h}}}var Kr=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);JM(r,o,this)}}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function Im(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var KM=37297,jM=0;function QM(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var Lm=new et;function eb(i){ct._getMatrix(Lm,ct.workingColorSpace,i);let e=`mat3( ${Lm.elements.map(t=>t.toFixed(4))} )`;switch(ct.getTransfer(i)){case Eo:return[e,"LinearTransferOETF"];case wt:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Dm(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),s=i.getShaderInfoLog(e).trim();if(n&&s==="")return"";let r=/ERROR: 0:(\d+)/.exec(s);if(r){let o=parseInt(r[1]);return t.toUpperCase()+`

`+s+`

`+QM(i.getShaderSource(e),o)}else return s}function tb(i,e){let t=eb(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function nb(i,e){let t;switch(e){case qp:t="Linear";break;case Yp:t="Reinhard";break;case $p:t="Cineon";break;case Zp:t="ACESFilmic";break;case Kp:t="AgX";break;case jp:t="Neutral";break;case Jp:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var sc=new J;function ib(){ct.getLuminanceCoefficients(sc);let i=sc.x.toFixed(4),e=sc.y.toFixed(4),t=sc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function sb(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ko).join(`
`)}function rb(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function ob(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Ko(i){return i!==""}function Um(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function Fm(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var ab=/^[ \t]*#include +<([\w\d./]+)>/gm;function wu(i){return i.replace(ab,cb)}var lb=new Map;function cb(i,e){let t=st[e];if(t===void 0){let n=lb.get(e);if(n!==void 0)t=st[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,n);else throw new Error("Can not resolve #include <"+e+">")}return wu(t)}var hb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Nm(i){return i.replace(hb,ub)}function ub(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Om(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}function fb(i){let e="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===Zh?e="SHADOWMAP_TYPE_PCF":i.shadowMapType===Tp?e="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Ti&&(e="SHADOWMAP_TYPE_VSM"),e}function db(i){let e="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case $s:case Zs:e="ENVMAP_TYPE_CUBE";break;case Go:e="ENVMAP_TYPE_CUBE_UV";break}return e}function pb(i){let e="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case Zs:e="ENVMAP_MODE_REFRACTION";break}return e}function mb(i){let e="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case Qh:e="ENVMAP_BLENDING_MULTIPLY";break;case Wp:e="ENVMAP_BLENDING_MIX";break;case Xp:e="ENVMAP_BLENDING_ADD";break}return e}function gb(i){let e=i.envMapCubeUVHeight;if(e===null)return null;let t=Math.log2(e)-2,n=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:n,maxMip:t}}function _b(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=fb(t),c=db(t),u=pb(t),h=mb(t),f=gb(t),d=sb(t),_=rb(r),M=s.createProgram(),m,p,E=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(Ko).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(Ko).join(`
`),p.length>0&&(p+=`
`)):(m=[Om(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",t.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ko).join(`
`),p=[Om(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",t.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==$i?"#define TONE_MAPPING":"",t.toneMapping!==$i?st.tonemapping_pars_fragment:"",t.toneMapping!==$i?nb("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",st.colorspace_pars_fragment,tb("linearToOutputTexel",t.outputColorSpace),ib(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ko).join(`
`)),o=wu(o),o=Um(o,t),o=Fm(o,t),a=wu(a),a=Um(a,t),a=Fm(a,t),o=Nm(o),a=Nm(a),t.isRawShaderMaterial!==!0&&(E=`#version 300 es
`,m=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",t.glslVersion===$r?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===$r?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let w=E+m+o,y=E+p+a,F=Im(s,s.VERTEX_SHADER,w),I=Im(s,s.FRAGMENT_SHADER,y);s.attachShader(M,F),s.attachShader(M,I),t.index0AttributeName!==void 0?s.bindAttribLocation(M,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(M,0,"position"),s.linkProgram(M);function L(R){if(i.debug.checkShaderErrors){let X=s.getProgramInfoLog(M).trim(),k=s.getShaderInfoLog(F).trim(),G=s.getShaderInfoLog(I).trim(),Y=!0,q=!0;if(s.getProgramParameter(M,s.LINK_STATUS)===!1)if(Y=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,M,F,I);else{let K=Dm(s,F,"vertex"),j=Dm(s,I,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(M,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+X+`
`+K+`
`+j)}else X!==""?console.warn("THREE.WebGLProgram: Program Info Log:",X):(k===""||G==="")&&(q=!1);q&&(R.diagnostics={runnable:Y,programLog:X,vertexShader:{log:k,prefix:m},fragmentShader:{log:G,prefix:p}})}s.deleteShader(F),s.deleteShader(I),B=new Kr(s,M),T=ob(s,M)}let B;this.getUniforms=function(){return B===void 0&&L(this),B};let T;this.getAttributes=function(){return T===void 0&&L(this),T};let b=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return b===!1&&(b=s.getProgramParameter(M,KM)),b},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(M),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=jM++,this.cacheKey=e,this.usedTimes=1,this.program=M,this.vertexShader=F,this.fragmentShader=I,this}var xb=0,Tu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){let t=e.vertexShader,n=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Eu(e),t.set(e,n)),n}},Eu=class{constructor(e){this.id=xb++,this.code=e,this.usedTimes=0}};function vb(i,e,t,n,s,r,o){let a=new Po,l=new Tu,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures,d=s.precision,_={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function M(T){return c.add(T),T===0?"uv":`uv${T}`}function m(T,b,R,X,k){let G=X.fog,Y=k.geometry,q=T.isMeshStandardMaterial?X.environment:null,K=(T.isMeshStandardMaterial?t:e).get(T.envMap||q),j=K&&K.mapping===Go?K.image.height:null,ce=_[T.type];T.precision!==null&&(d=s.getMaxPrecision(T.precision),d!==T.precision&&console.warn("THREE.WebGLProgram.getParameters:",T.precision,"not supported, using",d,"instead."));let le=Y.morphAttributes.position||Y.morphAttributes.normal||Y.morphAttributes.color,ge=le!==void 0?le.length:0,be=0;Y.morphAttributes.position!==void 0&&(be=1),Y.morphAttributes.normal!==void 0&&(be=2),Y.morphAttributes.color!==void 0&&(be=3);let pe,Q,he,_e;if(ce){let _t=Ri[ce];pe=_t.vertexShader,Q=_t.fragmentShader}else pe=T.vertexShader,Q=T.fragmentShader,l.update(T),he=l.getVertexShaderID(T),_e=l.getFragmentShaderID(T);let oe=i.getRenderTarget(),De=i.state.buffers.depth.getReversed(),Je=k.isInstancedMesh===!0,Te=k.isBatchedMesh===!0,ut=!!T.map,ft=!!T.matcap,Qe=!!K,U=!!T.aoMap,Ht=!!T.lightMap,rt=!!T.bumpMap,dt=!!T.normalMap,Oe=!!T.displacementMap,tt=!!T.emissiveMap,Pe=!!T.metalnessMap,$e=!!T.roughnessMap,St=T.anisotropy>0,P=T.clearcoat>0,x=T.dispersion>0,D=T.iridescence>0,Z=T.sheen>0,te=T.transmission>0,ee=St&&!!T.anisotropyMap,Fe=P&&!!T.clearcoatMap,me=P&&!!T.clearcoatNormalMap,Ie=P&&!!T.clearcoatRoughnessMap,Ee=D&&!!T.iridescenceMap,ie=D&&!!T.iridescenceThicknessMap,xe=Z&&!!T.sheenColorMap,Be=Z&&!!T.sheenRoughnessMap,He=!!T.specularMap,ve=!!T.specularColorMap,We=!!T.specularIntensityMap,N=te&&!!T.transmissionMap,ye=te&&!!T.thicknessMap,re=!!T.gradientMap,Le=!!T.alphaMap,ue=T.alphaTest>0,se=!!T.alphaHash,Ne=!!T.extensions,Ke=$i;T.toneMapped&&(oe===null||oe.isXRRenderTarget===!0)&&(Ke=i.toneMapping);let At={shaderID:ce,shaderType:T.type,shaderName:T.name,vertexShader:pe,fragmentShader:Q,defines:T.defines,customVertexShaderID:he,customFragmentShaderID:_e,isRawShaderMaterial:T.isRawShaderMaterial===!0,glslVersion:T.glslVersion,precision:d,batching:Te,batchingColor:Te&&k._colorsTexture!==null,instancing:Je,instancingColor:Je&&k.instanceColor!==null,instancingMorph:Je&&k.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:oe===null?i.outputColorSpace:oe.isXRRenderTarget===!0?oe.texture.colorSpace:Ws,alphaToCoverage:!!T.alphaToCoverage,map:ut,matcap:ft,envMap:Qe,envMapMode:Qe&&K.mapping,envMapCubeUVHeight:j,aoMap:U,lightMap:Ht,bumpMap:rt,normalMap:dt,displacementMap:f&&Oe,emissiveMap:tt,normalMapObjectSpace:dt&&T.normalMapType===im,normalMapTangentSpace:dt&&T.normalMapType===nm,metalnessMap:Pe,roughnessMap:$e,anisotropy:St,anisotropyMap:ee,clearcoat:P,clearcoatMap:Fe,clearcoatNormalMap:me,clearcoatRoughnessMap:Ie,dispersion:x,iridescence:D,iridescenceMap:Ee,iridescenceThicknessMap:ie,sheen:Z,sheenColorMap:xe,sheenRoughnessMap:Be,specularMap:He,specularColorMap:ve,specularIntensityMap:We,transmission:te,transmissionMap:N,thicknessMap:ye,gradientMap:re,opaque:T.transparent===!1&&T.blending===Hs&&T.alphaToCoverage===!1,alphaMap:Le,alphaTest:ue,alphaHash:se,combine:T.combine,mapUv:ut&&M(T.map.channel),aoMapUv:U&&M(T.aoMap.channel),lightMapUv:Ht&&M(T.lightMap.channel),bumpMapUv:rt&&M(T.bumpMap.channel),normalMapUv:dt&&M(T.normalMap.channel),displacementMapUv:Oe&&M(T.displacementMap.channel),emissiveMapUv:tt&&M(T.emissiveMap.channel),metalnessMapUv:Pe&&M(T.metalnessMap.channel),roughnessMapUv:$e&&M(T.roughnessMap.channel),anisotropyMapUv:ee&&M(T.anisotropyMap.channel),clearcoatMapUv:Fe&&M(T.clearcoatMap.channel),clearcoatNormalMapUv:me&&M(T.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Ie&&M(T.clearcoatRoughnessMap.channel),iridescenceMapUv:Ee&&M(T.iridescenceMap.channel),iridescenceThicknessMapUv:ie&&M(T.iridescenceThicknessMap.channel),sheenColorMapUv:xe&&M(T.sheenColorMap.channel),sheenRoughnessMapUv:Be&&M(T.sheenRoughnessMap.channel),specularMapUv:He&&M(T.specularMap.channel),specularColorMapUv:ve&&M(T.specularColorMap.channel),specularIntensityMapUv:We&&M(T.specularIntensityMap.channel),transmissionMapUv:N&&M(T.transmissionMap.channel),thicknessMapUv:ye&&M(T.thicknessMap.channel),alphaMapUv:Le&&M(T.alphaMap.channel),vertexTangents:!!Y.attributes.tangent&&(dt||St),vertexColors:T.vertexColors,vertexAlphas:T.vertexColors===!0&&!!Y.attributes.color&&Y.attributes.color.itemSize===4,pointsUvs:k.isPoints===!0&&!!Y.attributes.uv&&(ut||Le),fog:!!G,useFog:T.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:T.flatShading===!0&&T.wireframe===!1,sizeAttenuation:T.sizeAttenuation===!0,logarithmicDepthBuffer:h,reverseDepthBuffer:De,skinning:k.isSkinnedMesh===!0,morphTargets:Y.morphAttributes.position!==void 0,morphNormals:Y.morphAttributes.normal!==void 0,morphColors:Y.morphAttributes.color!==void 0,morphTargetsCount:ge,morphTextureStride:be,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:T.dithering,shadowMapEnabled:i.shadowMap.enabled&&R.length>0,shadowMapType:i.shadowMap.type,toneMapping:Ke,decodeVideoTexture:ut&&T.map.isVideoTexture===!0&&ct.getTransfer(T.map.colorSpace)===wt,decodeVideoTextureEmissive:tt&&T.emissiveMap.isVideoTexture===!0&&ct.getTransfer(T.emissiveMap.colorSpace)===wt,premultipliedAlpha:T.premultipliedAlpha,doubleSided:T.side===Ei,flipSided:T.side===Rn,useDepthPacking:T.depthPacking>=0,depthPacking:T.depthPacking||0,index0AttributeName:T.index0AttributeName,extensionClipCullDistance:Ne&&T.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ne&&T.extensions.multiDraw===!0||Te)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:T.customProgramCacheKey()};return At.vertexUv1s=c.has(1),At.vertexUv2s=c.has(2),At.vertexUv3s=c.has(3),c.clear(),At}function p(T){let b=[];if(T.shaderID?b.push(T.shaderID):(b.push(T.customVertexShaderID),b.push(T.customFragmentShaderID)),T.defines!==void 0)for(let R in T.defines)b.push(R),b.push(T.defines[R]);return T.isRawShaderMaterial===!1&&(E(b,T),w(b,T),b.push(i.outputColorSpace)),b.push(T.customProgramCacheKey),b.join()}function E(T,b){T.push(b.precision),T.push(b.outputColorSpace),T.push(b.envMapMode),T.push(b.envMapCubeUVHeight),T.push(b.mapUv),T.push(b.alphaMapUv),T.push(b.lightMapUv),T.push(b.aoMapUv),T.push(b.bumpMapUv),T.push(b.normalMapUv),T.push(b.displacementMapUv),T.push(b.emissiveMapUv),T.push(b.metalnessMapUv),T.push(b.roughnessMapUv),T.push(b.anisotropyMapUv),T.push(b.clearcoatMapUv),T.push(b.clearcoatNormalMapUv),T.push(b.clearcoatRoughnessMapUv),T.push(b.iridescenceMapUv),T.push(b.iridescenceThicknessMapUv),T.push(b.sheenColorMapUv),T.push(b.sheenRoughnessMapUv),T.push(b.specularMapUv),T.push(b.specularColorMapUv),T.push(b.specularIntensityMapUv),T.push(b.transmissionMapUv),T.push(b.thicknessMapUv),T.push(b.combine),T.push(b.fogExp2),T.push(b.sizeAttenuation),T.push(b.morphTargetsCount),T.push(b.morphAttributeCount),T.push(b.numDirLights),T.push(b.numPointLights),T.push(b.numSpotLights),T.push(b.numSpotLightMaps),T.push(b.numHemiLights),T.push(b.numRectAreaLights),T.push(b.numDirLightShadows),T.push(b.numPointLightShadows),T.push(b.numSpotLightShadows),T.push(b.numSpotLightShadowsWithMaps),T.push(b.numLightProbes),T.push(b.shadowMapType),T.push(b.toneMapping),T.push(b.numClippingPlanes),T.push(b.numClipIntersection),T.push(b.depthPacking)}function w(T,b){a.disableAll(),b.supportsVertexTextures&&a.enable(0),b.instancing&&a.enable(1),b.instancingColor&&a.enable(2),b.instancingMorph&&a.enable(3),b.matcap&&a.enable(4),b.envMap&&a.enable(5),b.normalMapObjectSpace&&a.enable(6),b.normalMapTangentSpace&&a.enable(7),b.clearcoat&&a.enable(8),b.iridescence&&a.enable(9),b.alphaTest&&a.enable(10),b.vertexColors&&a.enable(11),b.vertexAlphas&&a.enable(12),b.vertexUv1s&&a.enable(13),b.vertexUv2s&&a.enable(14),b.vertexUv3s&&a.enable(15),b.vertexTangents&&a.enable(16),b.anisotropy&&a.enable(17),b.alphaHash&&a.enable(18),b.batching&&a.enable(19),b.dispersion&&a.enable(20),b.batchingColor&&a.enable(21),b.gradientMap&&a.enable(22),T.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reverseDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),T.push(a.mask)}function y(T){let b=_[T.type],R;if(b){let X=Ri[b];R=gm.clone(X.uniforms)}else R=T.uniforms;return R}function F(T,b){let R;for(let X=0,k=u.length;X<k;X++){let G=u[X];if(G.cacheKey===b){R=G,++R.usedTimes;break}}return R===void 0&&(R=new _b(i,b,T,r),u.push(R)),R}function I(T){if(--T.usedTimes===0){let b=u.indexOf(T);u[b]=u[u.length-1],u.pop(),T.destroy()}}function L(T){l.remove(T)}function B(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:y,acquireProgram:F,releaseProgram:I,releaseShaderCache:L,programs:u,dispose:B}}function yb(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function Mb(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.z!==e.z?i.z-e.z:i.id-e.id}function Bm(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function km(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(h,f,d,_,M,m){let p=i[e];return p===void 0?(p={id:h.id,object:h,geometry:f,material:d,groupOrder:_,renderOrder:h.renderOrder,z:M,group:m},i[e]=p):(p.id=h.id,p.object=h,p.geometry=f,p.material=d,p.groupOrder=_,p.renderOrder=h.renderOrder,p.z=M,p.group=m),e++,p}function a(h,f,d,_,M,m){let p=o(h,f,d,_,M,m);d.transmission>0?n.push(p):d.transparent===!0?s.push(p):t.push(p)}function l(h,f,d,_,M,m){let p=o(h,f,d,_,M,m);d.transmission>0?n.unshift(p):d.transparent===!0?s.unshift(p):t.unshift(p)}function c(h,f){t.length>1&&t.sort(h||Mb),n.length>1&&n.sort(f||Bm),s.length>1&&s.sort(f||Bm)}function u(){for(let h=e,f=i.length;h<f;h++){let d=i[h];if(d.id===null)break;d.id=null,d.object=null,d.geometry=null,d.material=null,d.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function bb(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new km,i.set(n,[o])):s>=r.length?(o=new km,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function Sb(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new J,color:new yt};break;case"SpotLight":t={position:new J,direction:new J,color:new yt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new J,color:new yt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new J,skyColor:new yt,groundColor:new yt};break;case"RectAreaLight":t={color:new yt,position:new J,halfWidth:new J,halfHeight:new J};break}return i[e.id]=t,t}}}function wb(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Tt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Tt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Tt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var Tb=0;function Eb(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function Ab(i){let e=new Sb,t=wb(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new J);let s=new J,r=new Kt,o=new Kt;function a(c){let u=0,h=0,f=0;for(let T=0;T<9;T++)n.probe[T].set(0,0,0);let d=0,_=0,M=0,m=0,p=0,E=0,w=0,y=0,F=0,I=0,L=0;c.sort(Eb);for(let T=0,b=c.length;T<b;T++){let R=c[T],X=R.color,k=R.intensity,G=R.distance,Y=R.shadow&&R.shadow.map?R.shadow.map.texture:null;if(R.isAmbientLight)u+=X.r*k,h+=X.g*k,f+=X.b*k;else if(R.isLightProbe){for(let q=0;q<9;q++)n.probe[q].addScaledVector(R.sh.coefficients[q],k);L++}else if(R.isDirectionalLight){let q=e.get(R);if(q.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){let K=R.shadow,j=t.get(R);j.shadowIntensity=K.intensity,j.shadowBias=K.bias,j.shadowNormalBias=K.normalBias,j.shadowRadius=K.radius,j.shadowMapSize=K.mapSize,n.directionalShadow[d]=j,n.directionalShadowMap[d]=Y,n.directionalShadowMatrix[d]=R.shadow.matrix,E++}n.directional[d]=q,d++}else if(R.isSpotLight){let q=e.get(R);q.position.setFromMatrixPosition(R.matrixWorld),q.color.copy(X).multiplyScalar(k),q.distance=G,q.coneCos=Math.cos(R.angle),q.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),q.decay=R.decay,n.spot[M]=q;let K=R.shadow;if(R.map&&(n.spotLightMap[F]=R.map,F++,K.updateMatrices(R),R.castShadow&&I++),n.spotLightMatrix[M]=K.matrix,R.castShadow){let j=t.get(R);j.shadowIntensity=K.intensity,j.shadowBias=K.bias,j.shadowNormalBias=K.normalBias,j.shadowRadius=K.radius,j.shadowMapSize=K.mapSize,n.spotShadow[M]=j,n.spotShadowMap[M]=Y,y++}M++}else if(R.isRectAreaLight){let q=e.get(R);q.color.copy(X).multiplyScalar(k),q.halfWidth.set(R.width*.5,0,0),q.halfHeight.set(0,R.height*.5,0),n.rectArea[m]=q,m++}else if(R.isPointLight){let q=e.get(R);if(q.color.copy(R.color).multiplyScalar(R.intensity),q.distance=R.distance,q.decay=R.decay,R.castShadow){let K=R.shadow,j=t.get(R);j.shadowIntensity=K.intensity,j.shadowBias=K.bias,j.shadowNormalBias=K.normalBias,j.shadowRadius=K.radius,j.shadowMapSize=K.mapSize,j.shadowCameraNear=K.camera.near,j.shadowCameraFar=K.camera.far,n.pointShadow[_]=j,n.pointShadowMap[_]=Y,n.pointShadowMatrix[_]=R.shadow.matrix,w++}n.point[_]=q,_++}else if(R.isHemisphereLight){let q=e.get(R);q.skyColor.copy(R.color).multiplyScalar(k),q.groundColor.copy(R.groundColor).multiplyScalar(k),n.hemi[p]=q,p++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Se.LTC_FLOAT_1,n.rectAreaLTC2=Se.LTC_FLOAT_2):(n.rectAreaLTC1=Se.LTC_HALF_1,n.rectAreaLTC2=Se.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;let B=n.hash;(B.directionalLength!==d||B.pointLength!==_||B.spotLength!==M||B.rectAreaLength!==m||B.hemiLength!==p||B.numDirectionalShadows!==E||B.numPointShadows!==w||B.numSpotShadows!==y||B.numSpotMaps!==F||B.numLightProbes!==L)&&(n.directional.length=d,n.spot.length=M,n.rectArea.length=m,n.point.length=_,n.hemi.length=p,n.directionalShadow.length=E,n.directionalShadowMap.length=E,n.pointShadow.length=w,n.pointShadowMap.length=w,n.spotShadow.length=y,n.spotShadowMap.length=y,n.directionalShadowMatrix.length=E,n.pointShadowMatrix.length=w,n.spotLightMatrix.length=y+F-I,n.spotLightMap.length=F,n.numSpotLightShadowsWithMaps=I,n.numLightProbes=L,B.directionalLength=d,B.pointLength=_,B.spotLength=M,B.rectAreaLength=m,B.hemiLength=p,B.numDirectionalShadows=E,B.numPointShadows=w,B.numSpotShadows=y,B.numSpotMaps=F,B.numLightProbes=L,n.version=Tb++)}function l(c,u){let h=0,f=0,d=0,_=0,M=0,m=u.matrixWorldInverse;for(let p=0,E=c.length;p<E;p++){let w=c[p];if(w.isDirectionalLight){let y=n.directional[h];y.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(m),h++}else if(w.isSpotLight){let y=n.spot[d];y.position.setFromMatrixPosition(w.matrixWorld),y.position.applyMatrix4(m),y.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(m),d++}else if(w.isRectAreaLight){let y=n.rectArea[_];y.position.setFromMatrixPosition(w.matrixWorld),y.position.applyMatrix4(m),o.identity(),r.copy(w.matrixWorld),r.premultiply(m),o.extractRotation(r),y.halfWidth.set(w.width*.5,0,0),y.halfHeight.set(0,w.height*.5,0),y.halfWidth.applyMatrix4(o),y.halfHeight.applyMatrix4(o),_++}else if(w.isPointLight){let y=n.point[f];y.position.setFromMatrixPosition(w.matrixWorld),y.position.applyMatrix4(m),f++}else if(w.isHemisphereLight){let y=n.hemi[M];y.direction.setFromMatrixPosition(w.matrixWorld),y.direction.transformDirection(m),M++}}}return{setup:a,setupView:l,state:n}}function zm(i){let e=new Ab(i),t=[],n=[];function s(u){c.camera=u,t.length=0,n.length=0}function r(u){t.push(u)}function o(u){n.push(u)}function a(){e.setup(t)}function l(u){e.setupView(t,u)}let c={lightsArray:t,shadowsArray:n,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function Cb(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new zm(i),e.set(s,[a])):r>=o.length?(a=new zm(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var Rb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Pb=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function Ib(i,e,t){let n=new Bo,s=new Tt,r=new Tt,o=new zt,a=new nl({depthPacking:tm}),l=new il,c={},u=t.maxTextureSize,h={[Wi]:Rn,[Rn]:Wi,[Ei]:Ei},f=new si({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Tt},radius:{value:4}},vertexShader:Rb,fragmentShader:Pb}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let _=new ii;_.setAttribute("position",new jt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let M=new Cn(_,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Zh;let p=this.type;this.render=function(I,L,B){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||I.length===0)return;let T=i.getRenderTarget(),b=i.getActiveCubeFace(),R=i.getActiveMipmapLevel(),X=i.state;X.setBlending(Yi),X.buffers.color.setClear(1,1,1,1),X.buffers.depth.setTest(!0),X.setScissorTest(!1);let k=p!==Ti&&this.type===Ti,G=p===Ti&&this.type!==Ti;for(let Y=0,q=I.length;Y<q;Y++){let K=I[Y],j=K.shadow;if(j===void 0){console.warn("THREE.WebGLShadowMap:",K,"has no shadow.");continue}if(j.autoUpdate===!1&&j.needsUpdate===!1)continue;s.copy(j.mapSize);let ce=j.getFrameExtents();if(s.multiply(ce),r.copy(j.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ce.x),s.x=r.x*ce.x,j.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ce.y),s.y=r.y*ce.y,j.mapSize.y=r.y)),j.map===null||k===!0||G===!0){let ge=this.type!==Ti?{minFilter:Un,magFilter:Un}:{};j.map!==null&&j.map.dispose(),j.map=new Si(s.x,s.y,ge),j.map.texture.name=K.name+".shadowMap",j.camera.updateProjectionMatrix()}i.setRenderTarget(j.map),i.clear();let le=j.getViewportCount();for(let ge=0;ge<le;ge++){let be=j.getViewport(ge);o.set(r.x*be.x,r.y*be.y,r.x*be.z,r.y*be.w),X.viewport(o),j.updateMatrices(K,ge),n=j.getFrustum(),y(L,B,j.camera,K,this.type)}j.isPointLightShadow!==!0&&this.type===Ti&&E(j,B),j.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(T,b,R)};function E(I,L){let B=e.update(M);f.defines.VSM_SAMPLES!==I.blurSamples&&(f.defines.VSM_SAMPLES=I.blurSamples,d.defines.VSM_SAMPLES=I.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),I.mapPass===null&&(I.mapPass=new Si(s.x,s.y)),f.uniforms.shadow_pass.value=I.map.texture,f.uniforms.resolution.value=I.mapSize,f.uniforms.radius.value=I.radius,i.setRenderTarget(I.mapPass),i.clear(),i.renderBufferDirect(L,null,B,f,M,null),d.uniforms.shadow_pass.value=I.mapPass.texture,d.uniforms.resolution.value=I.mapSize,d.uniforms.radius.value=I.radius,i.setRenderTarget(I.map),i.clear(),i.renderBufferDirect(L,null,B,d,M,null)}function w(I,L,B,T){let b=null,R=B.isPointLight===!0?I.customDistanceMaterial:I.customDepthMaterial;if(R!==void 0)b=R;else if(b=B.isPointLight===!0?l:a,i.localClippingEnabled&&L.clipShadows===!0&&Array.isArray(L.clippingPlanes)&&L.clippingPlanes.length!==0||L.displacementMap&&L.displacementScale!==0||L.alphaMap&&L.alphaTest>0||L.map&&L.alphaTest>0||L.alphaToCoverage===!0){let X=b.uuid,k=L.uuid,G=c[X];G===void 0&&(G={},c[X]=G);let Y=G[k];Y===void 0&&(Y=b.clone(),G[k]=Y,L.addEventListener("dispose",F)),b=Y}if(b.visible=L.visible,b.wireframe=L.wireframe,T===Ti?b.side=L.shadowSide!==null?L.shadowSide:L.side:b.side=L.shadowSide!==null?L.shadowSide:h[L.side],b.alphaMap=L.alphaMap,b.alphaTest=L.alphaToCoverage===!0?.5:L.alphaTest,b.map=L.map,b.clipShadows=L.clipShadows,b.clippingPlanes=L.clippingPlanes,b.clipIntersection=L.clipIntersection,b.displacementMap=L.displacementMap,b.displacementScale=L.displacementScale,b.displacementBias=L.displacementBias,b.wireframeLinewidth=L.wireframeLinewidth,b.linewidth=L.linewidth,B.isPointLight===!0&&b.isMeshDistanceMaterial===!0){let X=i.properties.get(b);X.light=B}return b}function y(I,L,B,T,b){if(I.visible===!1)return;if(I.layers.test(L.layers)&&(I.isMesh||I.isLine||I.isPoints)&&(I.castShadow||I.receiveShadow&&b===Ti)&&(!I.frustumCulled||n.intersectsObject(I))){I.modelViewMatrix.multiplyMatrices(B.matrixWorldInverse,I.matrixWorld);let k=e.update(I),G=I.material;if(Array.isArray(G)){let Y=k.groups;for(let q=0,K=Y.length;q<K;q++){let j=Y[q],ce=G[j.materialIndex];if(ce&&ce.visible){let le=w(I,ce,T,b);I.onBeforeShadow(i,I,L,B,k,le,j),i.renderBufferDirect(B,null,k,le,I,j),I.onAfterShadow(i,I,L,B,k,le,j)}}}else if(G.visible){let Y=w(I,G,T,b);I.onBeforeShadow(i,I,L,B,k,Y,null),i.renderBufferDirect(B,null,k,Y,I,null),I.onAfterShadow(i,I,L,B,k,Y,null)}}let X=I.children;for(let k=0,G=X.length;k<G;k++)y(X[k],L,B,T,b)}function F(I){I.target.removeEventListener("dispose",F);for(let B in c){let T=c[B],b=I.target.uuid;b in T&&(T[b].dispose(),delete T[b])}}}var Lb={[pl]:ml,[gl]:vl,[_l]:yl,[Gs]:xl,[ml]:pl,[vl]:gl,[yl]:_l,[xl]:Gs};function Db(i,e){function t(){let N=!1,ye=new zt,re=null,Le=new zt(0,0,0,0);return{setMask:function(ue){re!==ue&&!N&&(i.colorMask(ue,ue,ue,ue),re=ue)},setLocked:function(ue){N=ue},setClear:function(ue,se,Ne,Ke,At){At===!0&&(ue*=Ke,se*=Ke,Ne*=Ke),ye.set(ue,se,Ne,Ke),Le.equals(ye)===!1&&(i.clearColor(ue,se,Ne,Ke),Le.copy(ye))},reset:function(){N=!1,re=null,Le.set(-1,0,0,0)}}}function n(){let N=!1,ye=!1,re=null,Le=null,ue=null;return{setReversed:function(se){if(ye!==se){let Ne=e.get("EXT_clip_control");se?Ne.clipControlEXT(Ne.LOWER_LEFT_EXT,Ne.ZERO_TO_ONE_EXT):Ne.clipControlEXT(Ne.LOWER_LEFT_EXT,Ne.NEGATIVE_ONE_TO_ONE_EXT),ye=se;let Ke=ue;ue=null,this.setClear(Ke)}},getReversed:function(){return ye},setTest:function(se){se?oe(i.DEPTH_TEST):De(i.DEPTH_TEST)},setMask:function(se){re!==se&&!N&&(i.depthMask(se),re=se)},setFunc:function(se){if(ye&&(se=Lb[se]),Le!==se){switch(se){case pl:i.depthFunc(i.NEVER);break;case ml:i.depthFunc(i.ALWAYS);break;case gl:i.depthFunc(i.LESS);break;case Gs:i.depthFunc(i.LEQUAL);break;case _l:i.depthFunc(i.EQUAL);break;case xl:i.depthFunc(i.GEQUAL);break;case vl:i.depthFunc(i.GREATER);break;case yl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Le=se}},setLocked:function(se){N=se},setClear:function(se){ue!==se&&(ye&&(se=1-se),i.clearDepth(se),ue=se)},reset:function(){N=!1,re=null,Le=null,ue=null,ye=!1}}}function s(){let N=!1,ye=null,re=null,Le=null,ue=null,se=null,Ne=null,Ke=null,At=null;return{setTest:function(_t){N||(_t?oe(i.STENCIL_TEST):De(i.STENCIL_TEST))},setMask:function(_t){ye!==_t&&!N&&(i.stencilMask(_t),ye=_t)},setFunc:function(_t,Qt,Lt){(re!==_t||Le!==Qt||ue!==Lt)&&(i.stencilFunc(_t,Qt,Lt),re=_t,Le=Qt,ue=Lt)},setOp:function(_t,Qt,Lt){(se!==_t||Ne!==Qt||Ke!==Lt)&&(i.stencilOp(_t,Qt,Lt),se=_t,Ne=Qt,Ke=Lt)},setLocked:function(_t){N=_t},setClear:function(_t){At!==_t&&(i.clearStencil(_t),At=_t)},reset:function(){N=!1,ye=null,re=null,Le=null,ue=null,se=null,Ne=null,Ke=null,At=null}}}let r=new t,o=new n,a=new s,l=new WeakMap,c=new WeakMap,u={},h={},f=new WeakMap,d=[],_=null,M=!1,m=null,p=null,E=null,w=null,y=null,F=null,I=null,L=new yt(0,0,0),B=0,T=!1,b=null,R=null,X=null,k=null,G=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),q=!1,K=0,j=i.getParameter(i.VERSION);j.indexOf("WebGL")!==-1?(K=parseFloat(/^WebGL (\d)/.exec(j)[1]),q=K>=1):j.indexOf("OpenGL ES")!==-1&&(K=parseFloat(/^OpenGL ES (\d)/.exec(j)[1]),q=K>=2);let ce=null,le={},ge=i.getParameter(i.SCISSOR_BOX),be=i.getParameter(i.VIEWPORT),pe=new zt().fromArray(ge),Q=new zt().fromArray(be);function he(N,ye,re,Le){let ue=new Uint8Array(4),se=i.createTexture();i.bindTexture(N,se),i.texParameteri(N,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(N,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ne=0;Ne<re;Ne++)N===i.TEXTURE_3D||N===i.TEXTURE_2D_ARRAY?i.texImage3D(ye,0,i.RGBA,1,1,Le,0,i.RGBA,i.UNSIGNED_BYTE,ue):i.texImage2D(ye+Ne,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ue);return se}let _e={};_e[i.TEXTURE_2D]=he(i.TEXTURE_2D,i.TEXTURE_2D,1),_e[i.TEXTURE_CUBE_MAP]=he(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),_e[i.TEXTURE_2D_ARRAY]=he(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),_e[i.TEXTURE_3D]=he(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),oe(i.DEPTH_TEST),o.setFunc(Gs),rt(!1),dt($h),oe(i.CULL_FACE),U(Yi);function oe(N){u[N]!==!0&&(i.enable(N),u[N]=!0)}function De(N){u[N]!==!1&&(i.disable(N),u[N]=!1)}function Je(N,ye){return h[N]!==ye?(i.bindFramebuffer(N,ye),h[N]=ye,N===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=ye),N===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=ye),!0):!1}function Te(N,ye){let re=d,Le=!1;if(N){re=f.get(ye),re===void 0&&(re=[],f.set(ye,re));let ue=N.textures;if(re.length!==ue.length||re[0]!==i.COLOR_ATTACHMENT0){for(let se=0,Ne=ue.length;se<Ne;se++)re[se]=i.COLOR_ATTACHMENT0+se;re.length=ue.length,Le=!0}}else re[0]!==i.BACK&&(re[0]=i.BACK,Le=!0);Le&&i.drawBuffers(re)}function ut(N){return _!==N?(i.useProgram(N),_=N,!0):!1}let ft={[ms]:i.FUNC_ADD,[Ap]:i.FUNC_SUBTRACT,[Cp]:i.FUNC_REVERSE_SUBTRACT};ft[Rp]=i.MIN,ft[Pp]=i.MAX;let Qe={[Ip]:i.ZERO,[Lp]:i.ONE,[Dp]:i.SRC_COLOR,[Wa]:i.SRC_ALPHA,[kp]:i.SRC_ALPHA_SATURATE,[Op]:i.DST_COLOR,[Fp]:i.DST_ALPHA,[Up]:i.ONE_MINUS_SRC_COLOR,[Xa]:i.ONE_MINUS_SRC_ALPHA,[Bp]:i.ONE_MINUS_DST_COLOR,[Np]:i.ONE_MINUS_DST_ALPHA,[zp]:i.CONSTANT_COLOR,[Vp]:i.ONE_MINUS_CONSTANT_COLOR,[Hp]:i.CONSTANT_ALPHA,[Gp]:i.ONE_MINUS_CONSTANT_ALPHA};function U(N,ye,re,Le,ue,se,Ne,Ke,At,_t){if(N===Yi){M===!0&&(De(i.BLEND),M=!1);return}if(M===!1&&(oe(i.BLEND),M=!0),N!==Ep){if(N!==m||_t!==T){if((p!==ms||y!==ms)&&(i.blendEquation(i.FUNC_ADD),p=ms,y=ms),_t)switch(N){case Hs:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Jh:i.blendFunc(i.ONE,i.ONE);break;case Kh:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case jh:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",N);break}else switch(N){case Hs:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Jh:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Kh:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case jh:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",N);break}E=null,w=null,F=null,I=null,L.set(0,0,0),B=0,m=N,T=_t}return}ue=ue||ye,se=se||re,Ne=Ne||Le,(ye!==p||ue!==y)&&(i.blendEquationSeparate(ft[ye],ft[ue]),p=ye,y=ue),(re!==E||Le!==w||se!==F||Ne!==I)&&(i.blendFuncSeparate(Qe[re],Qe[Le],Qe[se],Qe[Ne]),E=re,w=Le,F=se,I=Ne),(Ke.equals(L)===!1||At!==B)&&(i.blendColor(Ke.r,Ke.g,Ke.b,At),L.copy(Ke),B=At),m=N,T=!1}function Ht(N,ye){N.side===Ei?De(i.CULL_FACE):oe(i.CULL_FACE);let re=N.side===Rn;ye&&(re=!re),rt(re),N.blending===Hs&&N.transparent===!1?U(Yi):U(N.blending,N.blendEquation,N.blendSrc,N.blendDst,N.blendEquationAlpha,N.blendSrcAlpha,N.blendDstAlpha,N.blendColor,N.blendAlpha,N.premultipliedAlpha),o.setFunc(N.depthFunc),o.setTest(N.depthTest),o.setMask(N.depthWrite),r.setMask(N.colorWrite);let Le=N.stencilWrite;a.setTest(Le),Le&&(a.setMask(N.stencilWriteMask),a.setFunc(N.stencilFunc,N.stencilRef,N.stencilFuncMask),a.setOp(N.stencilFail,N.stencilZFail,N.stencilZPass)),tt(N.polygonOffset,N.polygonOffsetFactor,N.polygonOffsetUnits),N.alphaToCoverage===!0?oe(i.SAMPLE_ALPHA_TO_COVERAGE):De(i.SAMPLE_ALPHA_TO_COVERAGE)}function rt(N){b!==N&&(N?i.frontFace(i.CW):i.frontFace(i.CCW),b=N)}function dt(N){N!==Sp?(oe(i.CULL_FACE),N!==R&&(N===$h?i.cullFace(i.BACK):N===wp?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):De(i.CULL_FACE),R=N}function Oe(N){N!==X&&(q&&i.lineWidth(N),X=N)}function tt(N,ye,re){N?(oe(i.POLYGON_OFFSET_FILL),(k!==ye||G!==re)&&(i.polygonOffset(ye,re),k=ye,G=re)):De(i.POLYGON_OFFSET_FILL)}function Pe(N){N?oe(i.SCISSOR_TEST):De(i.SCISSOR_TEST)}function $e(N){N===void 0&&(N=i.TEXTURE0+Y-1),ce!==N&&(i.activeTexture(N),ce=N)}function St(N,ye,re){re===void 0&&(ce===null?re=i.TEXTURE0+Y-1:re=ce);let Le=le[re];Le===void 0&&(Le={type:void 0,texture:void 0},le[re]=Le),(Le.type!==N||Le.texture!==ye)&&(ce!==re&&(i.activeTexture(re),ce=re),i.bindTexture(N,ye||_e[N]),Le.type=N,Le.texture=ye)}function P(){let N=le[ce];N!==void 0&&N.type!==void 0&&(i.bindTexture(N.type,null),N.type=void 0,N.texture=void 0)}function x(){try{i.compressedTexImage2D(...arguments)}catch(N){console.error("THREE.WebGLState:",N)}}function D(){try{i.compressedTexImage3D(...arguments)}catch(N){console.error("THREE.WebGLState:",N)}}function Z(){try{i.texSubImage2D(...arguments)}catch(N){console.error("THREE.WebGLState:",N)}}function te(){try{i.texSubImage3D(...arguments)}catch(N){console.error("THREE.WebGLState:",N)}}function ee(){try{i.compressedTexSubImage2D(...arguments)}catch(N){console.error("THREE.WebGLState:",N)}}function Fe(){try{i.compressedTexSubImage3D(...arguments)}catch(N){console.error("THREE.WebGLState:",N)}}function me(){try{i.texStorage2D(...arguments)}catch(N){console.error("THREE.WebGLState:",N)}}function Ie(){try{i.texStorage3D(...arguments)}catch(N){console.error("THREE.WebGLState:",N)}}function Ee(){try{i.texImage2D(...arguments)}catch(N){console.error("THREE.WebGLState:",N)}}function ie(){try{i.texImage3D(...arguments)}catch(N){console.error("THREE.WebGLState:",N)}}function xe(N){pe.equals(N)===!1&&(i.scissor(N.x,N.y,N.z,N.w),pe.copy(N))}function Be(N){Q.equals(N)===!1&&(i.viewport(N.x,N.y,N.z,N.w),Q.copy(N))}function He(N,ye){let re=c.get(ye);re===void 0&&(re=new WeakMap,c.set(ye,re));let Le=re.get(N);Le===void 0&&(Le=i.getUniformBlockIndex(ye,N.name),re.set(N,Le))}function ve(N,ye){let Le=c.get(ye).get(N);l.get(ye)!==Le&&(i.uniformBlockBinding(ye,Le,N.__bindingPointIndex),l.set(ye,Le))}function We(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),u={},ce=null,le={},h={},f=new WeakMap,d=[],_=null,M=!1,m=null,p=null,E=null,w=null,y=null,F=null,I=null,L=new yt(0,0,0),B=0,T=!1,b=null,R=null,X=null,k=null,G=null,pe.set(0,0,i.canvas.width,i.canvas.height),Q.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:oe,disable:De,bindFramebuffer:Je,drawBuffers:Te,useProgram:ut,setBlending:U,setMaterial:Ht,setFlipSided:rt,setCullFace:dt,setLineWidth:Oe,setPolygonOffset:tt,setScissorTest:Pe,activeTexture:$e,bindTexture:St,unbindTexture:P,compressedTexImage2D:x,compressedTexImage3D:D,texImage2D:Ee,texImage3D:ie,updateUBOMapping:He,uniformBlockBinding:ve,texStorage2D:me,texStorage3D:Ie,texSubImage2D:Z,texSubImage3D:te,compressedTexSubImage2D:ee,compressedTexSubImage3D:Fe,scissor:xe,viewport:Be,reset:We}}function Ub(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Tt,u=new WeakMap,h,f=new WeakMap,d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(P,x){return d?new OffscreenCanvas(P,x):Co("canvas")}function M(P,x,D){let Z=1,te=St(P);if((te.width>D||te.height>D)&&(Z=D/Math.max(te.width,te.height)),Z<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let ee=Math.floor(Z*te.width),Fe=Math.floor(Z*te.height);h===void 0&&(h=_(ee,Fe));let me=x?_(ee,Fe):h;return me.width=ee,me.height=Fe,me.getContext("2d").drawImage(P,0,0,ee,Fe),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+te.width+"x"+te.height+") to ("+ee+"x"+Fe+")."),me}else return"data"in P&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+te.width+"x"+te.height+")."),P;return P}function m(P){return P.generateMipmaps}function p(P){i.generateMipmap(P)}function E(P){return P.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?i.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function w(P,x,D,Z,te=!1){if(P!==null){if(i[P]!==void 0)return i[P];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let ee=x;if(x===i.RED&&(D===i.FLOAT&&(ee=i.R32F),D===i.HALF_FLOAT&&(ee=i.R16F),D===i.UNSIGNED_BYTE&&(ee=i.R8)),x===i.RED_INTEGER&&(D===i.UNSIGNED_BYTE&&(ee=i.R8UI),D===i.UNSIGNED_SHORT&&(ee=i.R16UI),D===i.UNSIGNED_INT&&(ee=i.R32UI),D===i.BYTE&&(ee=i.R8I),D===i.SHORT&&(ee=i.R16I),D===i.INT&&(ee=i.R32I)),x===i.RG&&(D===i.FLOAT&&(ee=i.RG32F),D===i.HALF_FLOAT&&(ee=i.RG16F),D===i.UNSIGNED_BYTE&&(ee=i.RG8)),x===i.RG_INTEGER&&(D===i.UNSIGNED_BYTE&&(ee=i.RG8UI),D===i.UNSIGNED_SHORT&&(ee=i.RG16UI),D===i.UNSIGNED_INT&&(ee=i.RG32UI),D===i.BYTE&&(ee=i.RG8I),D===i.SHORT&&(ee=i.RG16I),D===i.INT&&(ee=i.RG32I)),x===i.RGB_INTEGER&&(D===i.UNSIGNED_BYTE&&(ee=i.RGB8UI),D===i.UNSIGNED_SHORT&&(ee=i.RGB16UI),D===i.UNSIGNED_INT&&(ee=i.RGB32UI),D===i.BYTE&&(ee=i.RGB8I),D===i.SHORT&&(ee=i.RGB16I),D===i.INT&&(ee=i.RGB32I)),x===i.RGBA_INTEGER&&(D===i.UNSIGNED_BYTE&&(ee=i.RGBA8UI),D===i.UNSIGNED_SHORT&&(ee=i.RGBA16UI),D===i.UNSIGNED_INT&&(ee=i.RGBA32UI),D===i.BYTE&&(ee=i.RGBA8I),D===i.SHORT&&(ee=i.RGBA16I),D===i.INT&&(ee=i.RGBA32I)),x===i.RGB&&D===i.UNSIGNED_INT_5_9_9_9_REV&&(ee=i.RGB9_E5),x===i.RGBA){let Fe=te?Eo:ct.getTransfer(Z);D===i.FLOAT&&(ee=i.RGBA32F),D===i.HALF_FLOAT&&(ee=i.RGBA16F),D===i.UNSIGNED_BYTE&&(ee=Fe===wt?i.SRGB8_ALPHA8:i.RGBA8),D===i.UNSIGNED_SHORT_4_4_4_4&&(ee=i.RGBA4),D===i.UNSIGNED_SHORT_5_5_5_1&&(ee=i.RGB5_A1)}return(ee===i.R16F||ee===i.R32F||ee===i.RG16F||ee===i.RG32F||ee===i.RGBA16F||ee===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function y(P,x){let D;return P?x===null||x===ys||x===qr?D=i.DEPTH24_STENCIL8:x===Ci?D=i.DEPTH32F_STENCIL8:x===Wr&&(D=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===ys||x===qr?D=i.DEPTH_COMPONENT24:x===Ci?D=i.DEPTH_COMPONENT32F:x===Wr&&(D=i.DEPTH_COMPONENT16),D}function F(P,x){return m(P)===!0||P.isFramebufferTexture&&P.minFilter!==Un&&P.minFilter!==Zn?Math.log2(Math.max(x.width,x.height))+1:P.mipmaps!==void 0&&P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?x.mipmaps.length:1}function I(P){let x=P.target;x.removeEventListener("dispose",I),B(x),x.isVideoTexture&&u.delete(x)}function L(P){let x=P.target;x.removeEventListener("dispose",L),b(x)}function B(P){let x=n.get(P);if(x.__webglInit===void 0)return;let D=P.source,Z=f.get(D);if(Z){let te=Z[x.__cacheKey];te.usedTimes--,te.usedTimes===0&&T(P),Object.keys(Z).length===0&&f.delete(D)}n.remove(P)}function T(P){let x=n.get(P);i.deleteTexture(x.__webglTexture);let D=P.source,Z=f.get(D);delete Z[x.__cacheKey],o.memory.textures--}function b(P){let x=n.get(P);if(P.depthTexture&&(P.depthTexture.dispose(),n.remove(P.depthTexture)),P.isWebGLCubeRenderTarget)for(let Z=0;Z<6;Z++){if(Array.isArray(x.__webglFramebuffer[Z]))for(let te=0;te<x.__webglFramebuffer[Z].length;te++)i.deleteFramebuffer(x.__webglFramebuffer[Z][te]);else i.deleteFramebuffer(x.__webglFramebuffer[Z]);x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer[Z])}else{if(Array.isArray(x.__webglFramebuffer))for(let Z=0;Z<x.__webglFramebuffer.length;Z++)i.deleteFramebuffer(x.__webglFramebuffer[Z]);else i.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&i.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let Z=0;Z<x.__webglColorRenderbuffer.length;Z++)x.__webglColorRenderbuffer[Z]&&i.deleteRenderbuffer(x.__webglColorRenderbuffer[Z]);x.__webglDepthRenderbuffer&&i.deleteRenderbuffer(x.__webglDepthRenderbuffer)}let D=P.textures;for(let Z=0,te=D.length;Z<te;Z++){let ee=n.get(D[Z]);ee.__webglTexture&&(i.deleteTexture(ee.__webglTexture),o.memory.textures--),n.remove(D[Z])}n.remove(P)}let R=0;function X(){R=0}function k(){let P=R;return P>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+P+" texture units while this GPU supports only "+s.maxTextures),R+=1,P}function G(P){let x=[];return x.push(P.wrapS),x.push(P.wrapT),x.push(P.wrapR||0),x.push(P.magFilter),x.push(P.minFilter),x.push(P.anisotropy),x.push(P.internalFormat),x.push(P.format),x.push(P.type),x.push(P.generateMipmaps),x.push(P.premultiplyAlpha),x.push(P.flipY),x.push(P.unpackAlignment),x.push(P.colorSpace),x.join()}function Y(P,x){let D=n.get(P);if(P.isVideoTexture&&Pe(P),P.isRenderTargetTexture===!1&&P.version>0&&D.__version!==P.version){let Z=P.image;if(Z===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(Z.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{_e(D,P,x);return}}t.bindTexture(i.TEXTURE_2D,D.__webglTexture,i.TEXTURE0+x)}function q(P,x){let D=n.get(P);if(P.version>0&&D.__version!==P.version){_e(D,P,x);return}t.bindTexture(i.TEXTURE_2D_ARRAY,D.__webglTexture,i.TEXTURE0+x)}function K(P,x){let D=n.get(P);if(P.version>0&&D.__version!==P.version){_e(D,P,x);return}t.bindTexture(i.TEXTURE_3D,D.__webglTexture,i.TEXTURE0+x)}function j(P,x){let D=n.get(P);if(P.version>0&&D.__version!==P.version){oe(D,P,x);return}t.bindTexture(i.TEXTURE_CUBE_MAP,D.__webglTexture,i.TEXTURE0+x)}let ce={[qa]:i.REPEAT,[ps]:i.CLAMP_TO_EDGE,[Ya]:i.MIRRORED_REPEAT},le={[Un]:i.NEAREST,[Qp]:i.NEAREST_MIPMAP_NEAREST,[Wo]:i.NEAREST_MIPMAP_LINEAR,[Zn]:i.LINEAR,[Sl]:i.LINEAR_MIPMAP_NEAREST,[vs]:i.LINEAR_MIPMAP_LINEAR},ge={[sm]:i.NEVER,[hm]:i.ALWAYS,[rm]:i.LESS,[cu]:i.LEQUAL,[om]:i.EQUAL,[cm]:i.GEQUAL,[am]:i.GREATER,[lm]:i.NOTEQUAL};function be(P,x){if(x.type===Ci&&e.has("OES_texture_float_linear")===!1&&(x.magFilter===Zn||x.magFilter===Sl||x.magFilter===Wo||x.magFilter===vs||x.minFilter===Zn||x.minFilter===Sl||x.minFilter===Wo||x.minFilter===vs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(P,i.TEXTURE_WRAP_S,ce[x.wrapS]),i.texParameteri(P,i.TEXTURE_WRAP_T,ce[x.wrapT]),(P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY)&&i.texParameteri(P,i.TEXTURE_WRAP_R,ce[x.wrapR]),i.texParameteri(P,i.TEXTURE_MAG_FILTER,le[x.magFilter]),i.texParameteri(P,i.TEXTURE_MIN_FILTER,le[x.minFilter]),x.compareFunction&&(i.texParameteri(P,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(P,i.TEXTURE_COMPARE_FUNC,ge[x.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===Un||x.minFilter!==Wo&&x.minFilter!==vs||x.type===Ci&&e.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||n.get(x).__currentAnisotropy){let D=e.get("EXT_texture_filter_anisotropic");i.texParameterf(P,D.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),n.get(x).__currentAnisotropy=x.anisotropy}}}function pe(P,x){let D=!1;P.__webglInit===void 0&&(P.__webglInit=!0,x.addEventListener("dispose",I));let Z=x.source,te=f.get(Z);te===void 0&&(te={},f.set(Z,te));let ee=G(x);if(ee!==P.__cacheKey){te[ee]===void 0&&(te[ee]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,D=!0),te[ee].usedTimes++;let Fe=te[P.__cacheKey];Fe!==void 0&&(te[P.__cacheKey].usedTimes--,Fe.usedTimes===0&&T(x)),P.__cacheKey=ee,P.__webglTexture=te[ee].texture}return D}function Q(P,x,D){return Math.floor(Math.floor(P/D)/x)}function he(P,x,D,Z){let ee=P.updateRanges;if(ee.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,x.width,x.height,D,Z,x.data);else{ee.sort((ie,xe)=>ie.start-xe.start);let Fe=0;for(let ie=1;ie<ee.length;ie++){let xe=ee[Fe],Be=ee[ie],He=xe.start+xe.count,ve=Q(Be.start,x.width,4),We=Q(xe.start,x.width,4);Be.start<=He+1&&ve===We&&Q(Be.start+Be.count-1,x.width,4)===ve?xe.count=Math.max(xe.count,Be.start+Be.count-xe.start):(++Fe,ee[Fe]=Be)}ee.length=Fe+1;let me=i.getParameter(i.UNPACK_ROW_LENGTH),Ie=i.getParameter(i.UNPACK_SKIP_PIXELS),Ee=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,x.width);for(let ie=0,xe=ee.length;ie<xe;ie++){let Be=ee[ie],He=Math.floor(Be.start/4),ve=Math.ceil(Be.count/4),We=He%x.width,N=Math.floor(He/x.width),ye=ve,re=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,We),i.pixelStorei(i.UNPACK_SKIP_ROWS,N),t.texSubImage2D(i.TEXTURE_2D,0,We,N,ye,re,D,Z,x.data)}P.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,me),i.pixelStorei(i.UNPACK_SKIP_PIXELS,Ie),i.pixelStorei(i.UNPACK_SKIP_ROWS,Ee)}}function _e(P,x,D){let Z=i.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(Z=i.TEXTURE_2D_ARRAY),x.isData3DTexture&&(Z=i.TEXTURE_3D);let te=pe(P,x),ee=x.source;t.bindTexture(Z,P.__webglTexture,i.TEXTURE0+D);let Fe=n.get(ee);if(ee.version!==Fe.__version||te===!0){t.activeTexture(i.TEXTURE0+D);let me=ct.getPrimaries(ct.workingColorSpace),Ie=x.colorSpace===Zi?null:ct.getPrimaries(x.colorSpace),Ee=x.colorSpace===Zi||me===Ie?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ee);let ie=M(x.image,!1,s.maxTextureSize);ie=$e(x,ie);let xe=r.convert(x.format,x.colorSpace),Be=r.convert(x.type),He=w(x.internalFormat,xe,Be,x.colorSpace,x.isVideoTexture);be(Z,x);let ve,We=x.mipmaps,N=x.isVideoTexture!==!0,ye=Fe.__version===void 0||te===!0,re=ee.dataReady,Le=F(x,ie);if(x.isDepthTexture)He=y(x.format===Yr,x.type),ye&&(N?t.texStorage2D(i.TEXTURE_2D,1,He,ie.width,ie.height):t.texImage2D(i.TEXTURE_2D,0,He,ie.width,ie.height,0,xe,Be,null));else if(x.isDataTexture)if(We.length>0){N&&ye&&t.texStorage2D(i.TEXTURE_2D,Le,He,We[0].width,We[0].height);for(let ue=0,se=We.length;ue<se;ue++)ve=We[ue],N?re&&t.texSubImage2D(i.TEXTURE_2D,ue,0,0,ve.width,ve.height,xe,Be,ve.data):t.texImage2D(i.TEXTURE_2D,ue,He,ve.width,ve.height,0,xe,Be,ve.data);x.generateMipmaps=!1}else N?(ye&&t.texStorage2D(i.TEXTURE_2D,Le,He,ie.width,ie.height),re&&he(x,ie,xe,Be)):t.texImage2D(i.TEXTURE_2D,0,He,ie.width,ie.height,0,xe,Be,ie.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){N&&ye&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Le,He,We[0].width,We[0].height,ie.depth);for(let ue=0,se=We.length;ue<se;ue++)if(ve=We[ue],x.format!==Nn)if(xe!==null)if(N){if(re)if(x.layerUpdates.size>0){let Ne=pu(ve.width,ve.height,x.format,x.type);for(let Ke of x.layerUpdates){let At=ve.data.subarray(Ke*Ne/ve.data.BYTES_PER_ELEMENT,(Ke+1)*Ne/ve.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ue,0,0,Ke,ve.width,ve.height,1,xe,At)}x.clearLayerUpdates()}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ue,0,0,0,ve.width,ve.height,ie.depth,xe,ve.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ue,He,ve.width,ve.height,ie.depth,0,ve.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else N?re&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ue,0,0,0,ve.width,ve.height,ie.depth,xe,Be,ve.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ue,He,ve.width,ve.height,ie.depth,0,xe,Be,ve.data)}else{N&&ye&&t.texStorage2D(i.TEXTURE_2D,Le,He,We[0].width,We[0].height);for(let ue=0,se=We.length;ue<se;ue++)ve=We[ue],x.format!==Nn?xe!==null?N?re&&t.compressedTexSubImage2D(i.TEXTURE_2D,ue,0,0,ve.width,ve.height,xe,ve.data):t.compressedTexImage2D(i.TEXTURE_2D,ue,He,ve.width,ve.height,0,ve.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):N?re&&t.texSubImage2D(i.TEXTURE_2D,ue,0,0,ve.width,ve.height,xe,Be,ve.data):t.texImage2D(i.TEXTURE_2D,ue,He,ve.width,ve.height,0,xe,Be,ve.data)}else if(x.isDataArrayTexture)if(N){if(ye&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Le,He,ie.width,ie.height,ie.depth),re)if(x.layerUpdates.size>0){let ue=pu(ie.width,ie.height,x.format,x.type);for(let se of x.layerUpdates){let Ne=ie.data.subarray(se*ue/ie.data.BYTES_PER_ELEMENT,(se+1)*ue/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,se,ie.width,ie.height,1,xe,Be,Ne)}x.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,xe,Be,ie.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,He,ie.width,ie.height,ie.depth,0,xe,Be,ie.data);else if(x.isData3DTexture)N?(ye&&t.texStorage3D(i.TEXTURE_3D,Le,He,ie.width,ie.height,ie.depth),re&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,xe,Be,ie.data)):t.texImage3D(i.TEXTURE_3D,0,He,ie.width,ie.height,ie.depth,0,xe,Be,ie.data);else if(x.isFramebufferTexture){if(ye)if(N)t.texStorage2D(i.TEXTURE_2D,Le,He,ie.width,ie.height);else{let ue=ie.width,se=ie.height;for(let Ne=0;Ne<Le;Ne++)t.texImage2D(i.TEXTURE_2D,Ne,He,ue,se,0,xe,Be,null),ue>>=1,se>>=1}}else if(We.length>0){if(N&&ye){let ue=St(We[0]);t.texStorage2D(i.TEXTURE_2D,Le,He,ue.width,ue.height)}for(let ue=0,se=We.length;ue<se;ue++)ve=We[ue],N?re&&t.texSubImage2D(i.TEXTURE_2D,ue,0,0,xe,Be,ve):t.texImage2D(i.TEXTURE_2D,ue,He,xe,Be,ve);x.generateMipmaps=!1}else if(N){if(ye){let ue=St(ie);t.texStorage2D(i.TEXTURE_2D,Le,He,ue.width,ue.height)}re&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,xe,Be,ie)}else t.texImage2D(i.TEXTURE_2D,0,He,xe,Be,ie);m(x)&&p(Z),Fe.__version=ee.version,x.onUpdate&&x.onUpdate(x)}P.__version=x.version}function oe(P,x,D){if(x.image.length!==6)return;let Z=pe(P,x),te=x.source;t.bindTexture(i.TEXTURE_CUBE_MAP,P.__webglTexture,i.TEXTURE0+D);let ee=n.get(te);if(te.version!==ee.__version||Z===!0){t.activeTexture(i.TEXTURE0+D);let Fe=ct.getPrimaries(ct.workingColorSpace),me=x.colorSpace===Zi?null:ct.getPrimaries(x.colorSpace),Ie=x.colorSpace===Zi||Fe===me?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ie);let Ee=x.isCompressedTexture||x.image[0].isCompressedTexture,ie=x.image[0]&&x.image[0].isDataTexture,xe=[];for(let se=0;se<6;se++)!Ee&&!ie?xe[se]=M(x.image[se],!0,s.maxCubemapSize):xe[se]=ie?x.image[se].image:x.image[se],xe[se]=$e(x,xe[se]);let Be=xe[0],He=r.convert(x.format,x.colorSpace),ve=r.convert(x.type),We=w(x.internalFormat,He,ve,x.colorSpace),N=x.isVideoTexture!==!0,ye=ee.__version===void 0||Z===!0,re=te.dataReady,Le=F(x,Be);be(i.TEXTURE_CUBE_MAP,x);let ue;if(Ee){N&&ye&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Le,We,Be.width,Be.height);for(let se=0;se<6;se++){ue=xe[se].mipmaps;for(let Ne=0;Ne<ue.length;Ne++){let Ke=ue[Ne];x.format!==Nn?He!==null?N?re&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+se,Ne,0,0,Ke.width,Ke.height,He,Ke.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+se,Ne,We,Ke.width,Ke.height,0,Ke.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):N?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+se,Ne,0,0,Ke.width,Ke.height,He,ve,Ke.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+se,Ne,We,Ke.width,Ke.height,0,He,ve,Ke.data)}}}else{if(ue=x.mipmaps,N&&ye){ue.length>0&&Le++;let se=St(xe[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Le,We,se.width,se.height)}for(let se=0;se<6;se++)if(ie){N?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+se,0,0,0,xe[se].width,xe[se].height,He,ve,xe[se].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+se,0,We,xe[se].width,xe[se].height,0,He,ve,xe[se].data);for(let Ne=0;Ne<ue.length;Ne++){let At=ue[Ne].image[se].image;N?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+se,Ne+1,0,0,At.width,At.height,He,ve,At.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+se,Ne+1,We,At.width,At.height,0,He,ve,At.data)}}else{N?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+se,0,0,0,He,ve,xe[se]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+se,0,We,He,ve,xe[se]);for(let Ne=0;Ne<ue.length;Ne++){let Ke=ue[Ne];N?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+se,Ne+1,0,0,He,ve,Ke.image[se]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+se,Ne+1,We,He,ve,Ke.image[se])}}}m(x)&&p(i.TEXTURE_CUBE_MAP),ee.__version=te.version,x.onUpdate&&x.onUpdate(x)}P.__version=x.version}function De(P,x,D,Z,te,ee){let Fe=r.convert(D.format,D.colorSpace),me=r.convert(D.type),Ie=w(D.internalFormat,Fe,me,D.colorSpace),Ee=n.get(x),ie=n.get(D);if(ie.__renderTarget=x,!Ee.__hasExternalTextures){let xe=Math.max(1,x.width>>ee),Be=Math.max(1,x.height>>ee);te===i.TEXTURE_3D||te===i.TEXTURE_2D_ARRAY?t.texImage3D(te,ee,Ie,xe,Be,x.depth,0,Fe,me,null):t.texImage2D(te,ee,Ie,xe,Be,0,Fe,me,null)}t.bindFramebuffer(i.FRAMEBUFFER,P),tt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Z,te,ie.__webglTexture,0,Oe(x)):(te===i.TEXTURE_2D||te>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&te<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,Z,te,ie.__webglTexture,ee),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Je(P,x,D){if(i.bindRenderbuffer(i.RENDERBUFFER,P),x.depthBuffer){let Z=x.depthTexture,te=Z&&Z.isDepthTexture?Z.type:null,ee=y(x.stencilBuffer,te),Fe=x.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,me=Oe(x);tt(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,me,ee,x.width,x.height):D?i.renderbufferStorageMultisample(i.RENDERBUFFER,me,ee,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,ee,x.width,x.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Fe,i.RENDERBUFFER,P)}else{let Z=x.textures;for(let te=0;te<Z.length;te++){let ee=Z[te],Fe=r.convert(ee.format,ee.colorSpace),me=r.convert(ee.type),Ie=w(ee.internalFormat,Fe,me,ee.colorSpace),Ee=Oe(x);D&&tt(x)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ee,Ie,x.width,x.height):tt(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ee,Ie,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,Ie,x.width,x.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Te(P,x){if(x&&x.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(i.FRAMEBUFFER,P),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let Z=n.get(x.depthTexture);Z.__renderTarget=x,(!Z.__webglTexture||x.depthTexture.image.width!==x.width||x.depthTexture.image.height!==x.height)&&(x.depthTexture.image.width=x.width,x.depthTexture.image.height=x.height,x.depthTexture.needsUpdate=!0),Y(x.depthTexture,0);let te=Z.__webglTexture,ee=Oe(x);if(x.depthTexture.format===Nr)tt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,te,0,ee):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,te,0);else if(x.depthTexture.format===Yr)tt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,te,0,ee):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,te,0);else throw new Error("Unknown depthTexture format")}function ut(P){let x=n.get(P),D=P.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==P.depthTexture){let Z=P.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),Z){let te=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,Z.removeEventListener("dispose",te)};Z.addEventListener("dispose",te),x.__depthDisposeCallback=te}x.__boundDepthTexture=Z}if(P.depthTexture&&!x.__autoAllocateDepthBuffer){if(D)throw new Error("target.depthTexture not supported in Cube render targets");let Z=P.texture.mipmaps;Z&&Z.length>0?Te(x.__webglFramebuffer[0],P):Te(x.__webglFramebuffer,P)}else if(D){x.__webglDepthbuffer=[];for(let Z=0;Z<6;Z++)if(t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[Z]),x.__webglDepthbuffer[Z]===void 0)x.__webglDepthbuffer[Z]=i.createRenderbuffer(),Je(x.__webglDepthbuffer[Z],P,!1);else{let te=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ee=x.__webglDepthbuffer[Z];i.bindRenderbuffer(i.RENDERBUFFER,ee),i.framebufferRenderbuffer(i.FRAMEBUFFER,te,i.RENDERBUFFER,ee)}}else{let Z=P.texture.mipmaps;if(Z&&Z.length>0?t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=i.createRenderbuffer(),Je(x.__webglDepthbuffer,P,!1);else{let te=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ee=x.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ee),i.framebufferRenderbuffer(i.FRAMEBUFFER,te,i.RENDERBUFFER,ee)}}t.bindFramebuffer(i.FRAMEBUFFER,null)}function ft(P,x,D){let Z=n.get(P);x!==void 0&&De(Z.__webglFramebuffer,P,P.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),D!==void 0&&ut(P)}function Qe(P){let x=P.texture,D=n.get(P),Z=n.get(x);P.addEventListener("dispose",L);let te=P.textures,ee=P.isWebGLCubeRenderTarget===!0,Fe=te.length>1;if(Fe||(Z.__webglTexture===void 0&&(Z.__webglTexture=i.createTexture()),Z.__version=x.version,o.memory.textures++),ee){D.__webglFramebuffer=[];for(let me=0;me<6;me++)if(x.mipmaps&&x.mipmaps.length>0){D.__webglFramebuffer[me]=[];for(let Ie=0;Ie<x.mipmaps.length;Ie++)D.__webglFramebuffer[me][Ie]=i.createFramebuffer()}else D.__webglFramebuffer[me]=i.createFramebuffer()}else{if(x.mipmaps&&x.mipmaps.length>0){D.__webglFramebuffer=[];for(let me=0;me<x.mipmaps.length;me++)D.__webglFramebuffer[me]=i.createFramebuffer()}else D.__webglFramebuffer=i.createFramebuffer();if(Fe)for(let me=0,Ie=te.length;me<Ie;me++){let Ee=n.get(te[me]);Ee.__webglTexture===void 0&&(Ee.__webglTexture=i.createTexture(),o.memory.textures++)}if(P.samples>0&&tt(P)===!1){D.__webglMultisampledFramebuffer=i.createFramebuffer(),D.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,D.__webglMultisampledFramebuffer);for(let me=0;me<te.length;me++){let Ie=te[me];D.__webglColorRenderbuffer[me]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,D.__webglColorRenderbuffer[me]);let Ee=r.convert(Ie.format,Ie.colorSpace),ie=r.convert(Ie.type),xe=w(Ie.internalFormat,Ee,ie,Ie.colorSpace,P.isXRRenderTarget===!0),Be=Oe(P);i.renderbufferStorageMultisample(i.RENDERBUFFER,Be,xe,P.width,P.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,D.__webglColorRenderbuffer[me])}i.bindRenderbuffer(i.RENDERBUFFER,null),P.depthBuffer&&(D.__webglDepthRenderbuffer=i.createRenderbuffer(),Je(D.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ee){t.bindTexture(i.TEXTURE_CUBE_MAP,Z.__webglTexture),be(i.TEXTURE_CUBE_MAP,x);for(let me=0;me<6;me++)if(x.mipmaps&&x.mipmaps.length>0)for(let Ie=0;Ie<x.mipmaps.length;Ie++)De(D.__webglFramebuffer[me][Ie],P,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+me,Ie);else De(D.__webglFramebuffer[me],P,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+me,0);m(x)&&p(i.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Fe){for(let me=0,Ie=te.length;me<Ie;me++){let Ee=te[me],ie=n.get(Ee);t.bindTexture(i.TEXTURE_2D,ie.__webglTexture),be(i.TEXTURE_2D,Ee),De(D.__webglFramebuffer,P,Ee,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,0),m(Ee)&&p(i.TEXTURE_2D)}t.unbindTexture()}else{let me=i.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(me=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(me,Z.__webglTexture),be(me,x),x.mipmaps&&x.mipmaps.length>0)for(let Ie=0;Ie<x.mipmaps.length;Ie++)De(D.__webglFramebuffer[Ie],P,x,i.COLOR_ATTACHMENT0,me,Ie);else De(D.__webglFramebuffer,P,x,i.COLOR_ATTACHMENT0,me,0);m(x)&&p(me),t.unbindTexture()}P.depthBuffer&&ut(P)}function U(P){let x=P.textures;for(let D=0,Z=x.length;D<Z;D++){let te=x[D];if(m(te)){let ee=E(P),Fe=n.get(te).__webglTexture;t.bindTexture(ee,Fe),p(ee),t.unbindTexture()}}}let Ht=[],rt=[];function dt(P){if(P.samples>0){if(tt(P)===!1){let x=P.textures,D=P.width,Z=P.height,te=i.COLOR_BUFFER_BIT,ee=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Fe=n.get(P),me=x.length>1;if(me)for(let Ee=0;Ee<x.length;Ee++)t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ee,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ee,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Fe.__webglMultisampledFramebuffer);let Ie=P.texture.mipmaps;Ie&&Ie.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer);for(let Ee=0;Ee<x.length;Ee++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(te|=i.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(te|=i.STENCIL_BUFFER_BIT)),me){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Fe.__webglColorRenderbuffer[Ee]);let ie=n.get(x[Ee]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,ie,0)}i.blitFramebuffer(0,0,D,Z,0,0,D,Z,te,i.NEAREST),l===!0&&(Ht.length=0,rt.length=0,Ht.push(i.COLOR_ATTACHMENT0+Ee),P.depthBuffer&&P.resolveDepthBuffer===!1&&(Ht.push(ee),rt.push(ee),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,rt)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ht))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),me)for(let Ee=0;Ee<x.length;Ee++){t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ee,i.RENDERBUFFER,Fe.__webglColorRenderbuffer[Ee]);let ie=n.get(x[Ee]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ee,i.TEXTURE_2D,ie,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Fe.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.resolveDepthBuffer===!1&&l){let x=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[x])}}}function Oe(P){return Math.min(s.maxSamples,P.samples)}function tt(P){let x=n.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function Pe(P){let x=o.render.frame;u.get(P)!==x&&(u.set(P,x),P.update())}function $e(P,x){let D=P.colorSpace,Z=P.format,te=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||D!==Ws&&D!==Zi&&(ct.getTransfer(D)===wt?(Z!==Nn||te!==Ai)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",D)),x}function St(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=k,this.resetTextureUnits=X,this.setTexture2D=Y,this.setTexture2DArray=q,this.setTexture3D=K,this.setTextureCube=j,this.rebindTextures=ft,this.setupRenderTarget=Qe,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=dt,this.setupDepthRenderbuffer=ut,this.setupFrameBufferTexture=De,this.useMultisampledRTT=tt}function Fb(i,e){function t(n,s=Zi){let r,o=ct.getTransfer(s);if(n===Ai)return i.UNSIGNED_BYTE;if(n===Tl)return i.UNSIGNED_SHORT_4_4_4_4;if(n===El)return i.UNSIGNED_SHORT_5_5_5_1;if(n===iu)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===tu)return i.BYTE;if(n===nu)return i.SHORT;if(n===Wr)return i.UNSIGNED_SHORT;if(n===wl)return i.INT;if(n===ys)return i.UNSIGNED_INT;if(n===Ci)return i.FLOAT;if(n===Xr)return i.HALF_FLOAT;if(n===su)return i.ALPHA;if(n===ru)return i.RGB;if(n===Nn)return i.RGBA;if(n===Nr)return i.DEPTH_COMPONENT;if(n===Yr)return i.DEPTH_STENCIL;if(n===ou)return i.RED;if(n===Al)return i.RED_INTEGER;if(n===au)return i.RG;if(n===Cl)return i.RG_INTEGER;if(n===Rl)return i.RGBA_INTEGER;if(n===Xo||n===qo||n===Yo||n===$o)if(o===wt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Xo)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===qo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Yo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===$o)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Xo)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===qo)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Yo)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===$o)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Pl||n===Il||n===Ll||n===Dl)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Pl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Il)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Ll)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Dl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Ul||n===Fl||n===Nl)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Ul||n===Fl)return o===wt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Nl)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===Ol||n===Bl||n===kl||n===zl||n===Vl||n===Hl||n===Gl||n===Wl||n===Xl||n===ql||n===Yl||n===$l||n===Zl||n===Jl)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Ol)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Bl)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===kl)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===zl)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Vl)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Hl)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Gl)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Wl)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Xl)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===ql)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Yl)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===$l)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Zl)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Jl)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Zo||n===Kl||n===jl)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Zo)return o===wt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Kl)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===jl)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===lu||n===Ql||n===ec||n===tc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Zo)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Ql)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===ec)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===tc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===qr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var Nb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Ob=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Au=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t,n){if(this.texture===null){let s=new Fn,r=e.properties.get(s);r.__webglTexture=t.texture,(t.depthNear!==n.depthNear||t.depthFar!==n.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=s}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new si({vertexShader:Nb,fragmentShader:Ob,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Cn(new zo(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Cu=class extends Xi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,_=null,M=new Au,m=t.getContextAttributes(),p=null,E=null,w=[],y=[],F=new Tt,I=null,L=new Dn;L.viewport=new zt;let B=new Dn;B.viewport=new zt;let T=[L,B],b=new dl,R=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let he=w[Q];return he===void 0&&(he=new zr,w[Q]=he),he.getTargetRaySpace()},this.getControllerGrip=function(Q){let he=w[Q];return he===void 0&&(he=new zr,w[Q]=he),he.getGripSpace()},this.getHand=function(Q){let he=w[Q];return he===void 0&&(he=new zr,w[Q]=he),he.getHandSpace()};function k(Q){let he=y.indexOf(Q.inputSource);if(he===-1)return;let _e=w[he];_e!==void 0&&(_e.update(Q.inputSource,Q.frame,c||o),_e.dispatchEvent({type:Q.type,data:Q.inputSource}))}function G(){s.removeEventListener("select",k),s.removeEventListener("selectstart",k),s.removeEventListener("selectend",k),s.removeEventListener("squeeze",k),s.removeEventListener("squeezestart",k),s.removeEventListener("squeezeend",k),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",Y);for(let Q=0;Q<w.length;Q++){let he=y[Q];he!==null&&(y[Q]=null,w[Q].disconnect(he))}R=null,X=null,M.reset(),e.setRenderTarget(p),d=null,f=null,h=null,s=null,E=null,pe.stop(),n.isPresenting=!1,e.setPixelRatio(I),e.setSize(F.width,F.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(p=e.getRenderTarget(),s.addEventListener("select",k),s.addEventListener("selectstart",k),s.addEventListener("selectend",k),s.addEventListener("squeeze",k),s.addEventListener("squeezestart",k),s.addEventListener("squeezeend",k),s.addEventListener("end",G),s.addEventListener("inputsourceschange",Y),m.xrCompatible!==!0&&await t.makeXRCompatible(),I=e.getPixelRatio(),e.getSize(F),typeof XRWebGLBinding<"u"&&"createProjectionLayer"in XRWebGLBinding.prototype){let _e=null,oe=null,De=null;m.depth&&(De=m.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=m.stencil?Yr:Nr,oe=m.stencil?qr:ys);let Je={colorFormat:t.RGBA8,depthFormat:De,scaleFactor:r};h=new XRWebGLBinding(s,t),f=h.createProjectionLayer(Je),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),E=new Si(f.textureWidth,f.textureHeight,{format:Nn,type:Ai,depthTexture:new ko(f.textureWidth,f.textureHeight,oe,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:m.stencil,colorSpace:e.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{let _e={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,_e),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),E=new Si(d.framebufferWidth,d.framebufferHeight,{format:Nn,type:Ai,colorSpace:e.outputColorSpace,stencilBuffer:m.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}E.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),pe.setContext(s),pe.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return M.getDepthTexture()};function Y(Q){for(let he=0;he<Q.removed.length;he++){let _e=Q.removed[he],oe=y.indexOf(_e);oe>=0&&(y[oe]=null,w[oe].disconnect(_e))}for(let he=0;he<Q.added.length;he++){let _e=Q.added[he],oe=y.indexOf(_e);if(oe===-1){for(let Je=0;Je<w.length;Je++)if(Je>=y.length){y.push(_e),oe=Je;break}else if(y[Je]===null){y[Je]=_e,oe=Je;break}if(oe===-1)break}let De=w[oe];De&&De.connect(_e)}}let q=new J,K=new J;function j(Q,he,_e){q.setFromMatrixPosition(he.matrixWorld),K.setFromMatrixPosition(_e.matrixWorld);let oe=q.distanceTo(K),De=he.projectionMatrix.elements,Je=_e.projectionMatrix.elements,Te=De[14]/(De[10]-1),ut=De[14]/(De[10]+1),ft=(De[9]+1)/De[5],Qe=(De[9]-1)/De[5],U=(De[8]-1)/De[0],Ht=(Je[8]+1)/Je[0],rt=Te*U,dt=Te*Ht,Oe=oe/(-U+Ht),tt=Oe*-U;if(he.matrixWorld.decompose(Q.position,Q.quaternion,Q.scale),Q.translateX(tt),Q.translateZ(Oe),Q.matrixWorld.compose(Q.position,Q.quaternion,Q.scale),Q.matrixWorldInverse.copy(Q.matrixWorld).invert(),De[10]===-1)Q.projectionMatrix.copy(he.projectionMatrix),Q.projectionMatrixInverse.copy(he.projectionMatrixInverse);else{let Pe=Te+Oe,$e=ut+Oe,St=rt-tt,P=dt+(oe-tt),x=ft*ut/$e*Pe,D=Qe*ut/$e*Pe;Q.projectionMatrix.makePerspective(St,P,x,D,Pe,$e),Q.projectionMatrixInverse.copy(Q.projectionMatrix).invert()}}function ce(Q,he){he===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(he.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let he=Q.near,_e=Q.far;M.texture!==null&&(M.depthNear>0&&(he=M.depthNear),M.depthFar>0&&(_e=M.depthFar)),b.near=B.near=L.near=he,b.far=B.far=L.far=_e,(R!==b.near||X!==b.far)&&(s.updateRenderState({depthNear:b.near,depthFar:b.far}),R=b.near,X=b.far),L.layers.mask=Q.layers.mask|2,B.layers.mask=Q.layers.mask|4,b.layers.mask=L.layers.mask|B.layers.mask;let oe=Q.parent,De=b.cameras;ce(b,oe);for(let Je=0;Je<De.length;Je++)ce(De[Je],oe);De.length===2?j(b,L,B):b.projectionMatrix.copy(L.projectionMatrix),le(Q,b,oe)};function le(Q,he,_e){_e===null?Q.matrix.copy(he.matrixWorld):(Q.matrix.copy(_e.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(he.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(he.projectionMatrix),Q.projectionMatrixInverse.copy(he.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Za*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return b},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(Q){l=Q,f!==null&&(f.fixedFoveation=Q),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=Q)},this.hasDepthSensing=function(){return M.texture!==null},this.getDepthSensingMesh=function(){return M.getMesh(b)};let ge=null;function be(Q,he){if(u=he.getViewerPose(c||o),_=he,u!==null){let _e=u.views;d!==null&&(e.setRenderTargetFramebuffer(E,d.framebuffer),e.setRenderTarget(E));let oe=!1;_e.length!==b.cameras.length&&(b.cameras.length=0,oe=!0);for(let Te=0;Te<_e.length;Te++){let ut=_e[Te],ft=null;if(d!==null)ft=d.getViewport(ut);else{let U=h.getViewSubImage(f,ut);ft=U.viewport,Te===0&&(e.setRenderTargetTextures(E,U.colorTexture,U.depthStencilTexture),e.setRenderTarget(E))}let Qe=T[Te];Qe===void 0&&(Qe=new Dn,Qe.layers.enable(Te),Qe.viewport=new zt,T[Te]=Qe),Qe.matrix.fromArray(ut.transform.matrix),Qe.matrix.decompose(Qe.position,Qe.quaternion,Qe.scale),Qe.projectionMatrix.fromArray(ut.projectionMatrix),Qe.projectionMatrixInverse.copy(Qe.projectionMatrix).invert(),Qe.viewport.set(ft.x,ft.y,ft.width,ft.height),Te===0&&(b.matrix.copy(Qe.matrix),b.matrix.decompose(b.position,b.quaternion,b.scale)),oe===!0&&b.cameras.push(Qe)}let De=s.enabledFeatures;if(De&&De.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&h){let Te=h.getDepthInformation(_e[0]);Te&&Te.isValid&&Te.texture&&M.init(e,Te,s.renderState)}}for(let _e=0;_e<w.length;_e++){let oe=y[_e],De=w[_e];oe!==null&&De!==void 0&&De.update(oe,he,c||o)}ge&&ge(Q,he),he.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:he}),_=null}let pe=new Vm;pe.setAnimationLoop(be),this.setAnimationLoop=function(Q){ge=Q},this.dispose=function(){}}},js=new wi,Bb=new Kt;function kb(i,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,uu(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,E,w,y){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p)):p.isMeshStandardMaterial?(r(m,p),f(m,p),p.isMeshPhysicalMaterial&&d(m,p,y)):p.isMeshMatcapMaterial?(r(m,p),_(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),M(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,E,w):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Rn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Rn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let E=e.get(p),w=E.envMap,y=E.envMapRotation;w&&(m.envMap.value=w,js.copy(y),js.x*=-1,js.y*=-1,js.z*=-1,w.isCubeTexture&&w.isRenderTargetTexture===!1&&(js.y*=-1,js.z*=-1),m.envMapRotation.value.setFromMatrix4(Bb.makeRotationFromEuler(js)),m.flipEnvMap.value=w.isCubeTexture&&w.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,E,w){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*E,m.scale.value=w*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function f(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,E){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Rn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=E.texture,m.transmissionSamplerSize.value.set(E.width,E.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,p){p.matcap&&(m.matcap.value=p.matcap)}function M(m,p){let E=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(E.matrixWorld),m.nearDistance.value=E.shadow.camera.near,m.farDistance.value=E.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function zb(i,e,t,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(E,w){let y=w.program;n.uniformBlockBinding(E,y)}function c(E,w){let y=s[E.id];y===void 0&&(_(E),y=u(E),s[E.id]=y,E.addEventListener("dispose",m));let F=w.program;n.updateUBOMapping(E,F);let I=e.render.frame;r[E.id]!==I&&(f(E),r[E.id]=I)}function u(E){let w=h();E.__bindingPointIndex=w;let y=i.createBuffer(),F=E.__size,I=E.usage;return i.bindBuffer(i.UNIFORM_BUFFER,y),i.bufferData(i.UNIFORM_BUFFER,F,I),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,w,y),y}function h(){for(let E=0;E<a;E++)if(o.indexOf(E)===-1)return o.push(E),E;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(E){let w=s[E.id],y=E.uniforms,F=E.__cache;i.bindBuffer(i.UNIFORM_BUFFER,w);for(let I=0,L=y.length;I<L;I++){let B=Array.isArray(y[I])?y[I]:[y[I]];for(let T=0,b=B.length;T<b;T++){let R=B[T];if(d(R,I,T,F)===!0){let X=R.__offset,k=Array.isArray(R.value)?R.value:[R.value],G=0;for(let Y=0;Y<k.length;Y++){let q=k[Y],K=M(q);typeof q=="number"||typeof q=="boolean"?(R.__data[0]=q,i.bufferSubData(i.UNIFORM_BUFFER,X+G,R.__data)):q.isMatrix3?(R.__data[0]=q.elements[0],R.__data[1]=q.elements[1],R.__data[2]=q.elements[2],R.__data[3]=0,R.__data[4]=q.elements[3],R.__data[5]=q.elements[4],R.__data[6]=q.elements[5],R.__data[7]=0,R.__data[8]=q.elements[6],R.__data[9]=q.elements[7],R.__data[10]=q.elements[8],R.__data[11]=0):(q.toArray(R.__data,G),G+=K.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,X,R.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function d(E,w,y,F){let I=E.value,L=w+"_"+y;if(F[L]===void 0)return typeof I=="number"||typeof I=="boolean"?F[L]=I:F[L]=I.clone(),!0;{let B=F[L];if(typeof I=="number"||typeof I=="boolean"){if(B!==I)return F[L]=I,!0}else if(B.equals(I)===!1)return B.copy(I),!0}return!1}function _(E){let w=E.uniforms,y=0,F=16;for(let L=0,B=w.length;L<B;L++){let T=Array.isArray(w[L])?w[L]:[w[L]];for(let b=0,R=T.length;b<R;b++){let X=T[b],k=Array.isArray(X.value)?X.value:[X.value];for(let G=0,Y=k.length;G<Y;G++){let q=k[G],K=M(q),j=y%F,ce=j%K.boundary,le=j+ce;y+=ce,le!==0&&F-le<K.storage&&(y+=F-le),X.__data=new Float32Array(K.storage/Float32Array.BYTES_PER_ELEMENT),X.__offset=y,y+=K.storage}}}let I=y%F;return I>0&&(y+=F-I),E.__size=y,E.__cache={},this}function M(E){let w={boundary:0,storage:0};return typeof E=="number"||typeof E=="boolean"?(w.boundary=4,w.storage=4):E.isVector2?(w.boundary=8,w.storage=8):E.isVector3||E.isColor?(w.boundary=16,w.storage=12):E.isVector4?(w.boundary=16,w.storage=16):E.isMatrix3?(w.boundary=48,w.storage=48):E.isMatrix4?(w.boundary=64,w.storage=64):E.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",E),w}function m(E){let w=E.target;w.removeEventListener("dispose",m);let y=o.indexOf(w.__bindingPointIndex);o.splice(y,1),i.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function p(){for(let E in s)i.deleteBuffer(s[E]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}var oc=class{constructor(e={}){let{canvas:t=um(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reverseDepthBuffer:f=!1}=e;this.isWebGLRenderer=!0;let d;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");d=n.getContextAttributes().alpha}else d=o;let _=new Uint32Array(4),M=new Int32Array(4),m=null,p=null,E=[],w=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=$i,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let y=this,F=!1;this._outputColorSpace=$n;let I=0,L=0,B=null,T=-1,b=null,R=new zt,X=new zt,k=null,G=new yt(0),Y=0,q=t.width,K=t.height,j=1,ce=null,le=null,ge=new zt(0,0,q,K),be=new zt(0,0,q,K),pe=!1,Q=new Bo,he=!1,_e=!1,oe=new Kt,De=new Kt,Je=new J,Te=new zt,ut={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ft=!1;function Qe(){return B===null?j:1}let U=n;function Ht(S,z){return t.getContext(S,z)}try{let S={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"178"}`),t.addEventListener("webglcontextlost",Le,!1),t.addEventListener("webglcontextrestored",ue,!1),t.addEventListener("webglcontextcreationerror",se,!1),U===null){let z="webgl2";if(U=Ht(z,S),U===null)throw Ht(z)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(S){throw console.error("THREE.WebGLRenderer: "+S.message),S}let rt,dt,Oe,tt,Pe,$e,St,P,x,D,Z,te,ee,Fe,me,Ie,Ee,ie,xe,Be,He,ve,We,N;function ye(){rt=new sM(U),rt.init(),ve=new Fb(U,rt),dt=new Ky(U,rt,e,ve),Oe=new Db(U,rt),dt.reverseDepthBuffer&&f&&Oe.buffers.depth.setReversed(!0),tt=new aM(U),Pe=new yb,$e=new Ub(U,rt,Oe,Pe,dt,ve,tt),St=new Qy(y),P=new iM(y),x=new dx(U),We=new Zy(U,x),D=new rM(U,x,tt,We),Z=new cM(U,D,x,tt),xe=new lM(U,dt,$e),Ie=new jy(Pe),te=new vb(y,St,P,rt,dt,We,Ie),ee=new kb(y,Pe),Fe=new bb,me=new Cb(rt),ie=new $y(y,St,P,Oe,Z,d,l),Ee=new Ib(y,Z,dt),N=new zb(U,tt,dt,Oe),Be=new Jy(U,rt,tt),He=new oM(U,rt,tt),tt.programs=te.programs,y.capabilities=dt,y.extensions=rt,y.properties=Pe,y.renderLists=Fe,y.shadowMap=Ee,y.state=Oe,y.info=tt}ye();let re=new Cu(y,U);this.xr=re,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let S=rt.get("WEBGL_lose_context");S&&S.loseContext()},this.forceContextRestore=function(){let S=rt.get("WEBGL_lose_context");S&&S.restoreContext()},this.getPixelRatio=function(){return j},this.setPixelRatio=function(S){S!==void 0&&(j=S,this.setSize(q,K,!1))},this.getSize=function(S){return S.set(q,K)},this.setSize=function(S,z,W=!0){if(re.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}q=S,K=z,t.width=Math.floor(S*j),t.height=Math.floor(z*j),W===!0&&(t.style.width=S+"px",t.style.height=z+"px"),this.setViewport(0,0,S,z)},this.getDrawingBufferSize=function(S){return S.set(q*j,K*j).floor()},this.setDrawingBufferSize=function(S,z,W){q=S,K=z,j=W,t.width=Math.floor(S*W),t.height=Math.floor(z*W),this.setViewport(0,0,S,z)},this.getCurrentViewport=function(S){return S.copy(R)},this.getViewport=function(S){return S.copy(ge)},this.setViewport=function(S,z,W,$){S.isVector4?ge.set(S.x,S.y,S.z,S.w):ge.set(S,z,W,$),Oe.viewport(R.copy(ge).multiplyScalar(j).round())},this.getScissor=function(S){return S.copy(be)},this.setScissor=function(S,z,W,$){S.isVector4?be.set(S.x,S.y,S.z,S.w):be.set(S,z,W,$),Oe.scissor(X.copy(be).multiplyScalar(j).round())},this.getScissorTest=function(){return pe},this.setScissorTest=function(S){Oe.setScissorTest(pe=S)},this.setOpaqueSort=function(S){ce=S},this.setTransparentSort=function(S){le=S},this.getClearColor=function(S){return S.copy(ie.getClearColor())},this.setClearColor=function(){ie.setClearColor(...arguments)},this.getClearAlpha=function(){return ie.getClearAlpha()},this.setClearAlpha=function(){ie.setClearAlpha(...arguments)},this.clear=function(S=!0,z=!0,W=!0){let $=0;if(S){let V=!1;if(B!==null){let fe=B.texture.format;V=fe===Rl||fe===Cl||fe===Al}if(V){let fe=B.texture.type,Me=fe===Ai||fe===ys||fe===Wr||fe===qr||fe===Tl||fe===El,Re=ie.getClearColor(),Ce=ie.getClearAlpha(),Xe=Re.r,qe=Re.g,ze=Re.b;Me?(_[0]=Xe,_[1]=qe,_[2]=ze,_[3]=Ce,U.clearBufferuiv(U.COLOR,0,_)):(M[0]=Xe,M[1]=qe,M[2]=ze,M[3]=Ce,U.clearBufferiv(U.COLOR,0,M))}else $|=U.COLOR_BUFFER_BIT}z&&($|=U.DEPTH_BUFFER_BIT),W&&($|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),U.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",Le,!1),t.removeEventListener("webglcontextrestored",ue,!1),t.removeEventListener("webglcontextcreationerror",se,!1),ie.dispose(),Fe.dispose(),me.dispose(),Pe.dispose(),St.dispose(),P.dispose(),Z.dispose(),We.dispose(),N.dispose(),te.dispose(),re.dispose(),re.removeEventListener("sessionstart",On),re.removeEventListener("sessionend",Pi),Pn.stop()};function Le(S){S.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),F=!0}function ue(){console.log("THREE.WebGLRenderer: Context Restored."),F=!1;let S=tt.autoReset,z=Ee.enabled,W=Ee.autoUpdate,$=Ee.needsUpdate,V=Ee.type;ye(),tt.autoReset=S,Ee.enabled=z,Ee.autoUpdate=W,Ee.needsUpdate=$,Ee.type=V}function se(S){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",S.statusMessage)}function Ne(S){let z=S.target;z.removeEventListener("dispose",Ne),Ke(z)}function Ke(S){At(S),Pe.remove(S)}function At(S){let z=Pe.get(S).programs;z!==void 0&&(z.forEach(function(W){te.releaseProgram(W)}),S.isShaderMaterial&&te.releaseShaderCache(S))}this.renderBufferDirect=function(S,z,W,$,V,fe){z===null&&(z=ut);let Me=V.isMesh&&V.matrixWorld.determinant()<0,Re=dc(S,z,W,$,V);Oe.setMaterial($,Me);let Ce=W.index,Xe=1;if($.wireframe===!0){if(Ce=D.getWireframeAttribute(W),Ce===void 0)return;Xe=2}let qe=W.drawRange,ze=W.attributes.position,nt=qe.start*Xe,pt=(qe.start+qe.count)*Xe;fe!==null&&(nt=Math.max(nt,fe.start*Xe),pt=Math.min(pt,(fe.start+fe.count)*Xe)),Ce!==null?(nt=Math.max(nt,0),pt=Math.min(pt,Ce.count)):ze!=null&&(nt=Math.max(nt,0),pt=Math.min(pt,ze.count));let Dt=pt-nt;if(Dt<0||Dt===1/0)return;We.setup(V,$,Re,W,Ce);let it,Mt=Be;if(Ce!==null&&(it=x.get(Ce),Mt=He,Mt.setIndex(it)),V.isMesh)$.wireframe===!0?(Oe.setLineWidth($.wireframeLinewidth*Qe()),Mt.setMode(U.LINES)):Mt.setMode(U.TRIANGLES);else if(V.isLine){let Ge=$.linewidth;Ge===void 0&&(Ge=1),Oe.setLineWidth(Ge*Qe()),V.isLineSegments?Mt.setMode(U.LINES):V.isLineLoop?Mt.setMode(U.LINE_LOOP):Mt.setMode(U.LINE_STRIP)}else V.isPoints?Mt.setMode(U.POINTS):V.isSprite&&Mt.setMode(U.TRIANGLES);if(V.isBatchedMesh)if(V._multiDrawInstances!==null)Xs("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),Mt.renderMultiDrawInstances(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount,V._multiDrawInstances);else if(rt.get("WEBGL_multi_draw"))Mt.renderMultiDraw(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount);else{let Ge=V._multiDrawStarts,Ct=V._multiDrawCounts,lt=V._multiDrawCount,Mn=Ce?x.get(Ce).bytesPerElement:1,Ji=Pe.get($).currentProgram.getUniforms();for(let bn=0;bn<lt;bn++)Ji.setValue(U,"_gl_DrawID",bn),Mt.render(Ge[bn]/Mn,Ct[bn])}else if(V.isInstancedMesh)Mt.renderInstances(nt,Dt,V.count);else if(W.isInstancedBufferGeometry){let Ge=W._maxInstanceCount!==void 0?W._maxInstanceCount:1/0,Ct=Math.min(W.instanceCount,Ge);Mt.renderInstances(nt,Dt,Ct)}else Mt.render(nt,Dt)};function _t(S,z,W){S.transparent===!0&&S.side===Ei&&S.forceSinglePass===!1?(S.side=Rn,S.needsUpdate=!0,tr(S,z,W),S.side=Wi,S.needsUpdate=!0,tr(S,z,W),S.side=Ei):tr(S,z,W)}this.compile=function(S,z,W=null){W===null&&(W=S),p=me.get(W),p.init(z),w.push(p),W.traverseVisible(function(V){V.isLight&&V.layers.test(z.layers)&&(p.pushLight(V),V.castShadow&&p.pushShadow(V))}),S!==W&&S.traverseVisible(function(V){V.isLight&&V.layers.test(z.layers)&&(p.pushLight(V),V.castShadow&&p.pushShadow(V))}),p.setupLights();let $=new Set;return S.traverse(function(V){if(!(V.isMesh||V.isPoints||V.isLine||V.isSprite))return;let fe=V.material;if(fe)if(Array.isArray(fe))for(let Me=0;Me<fe.length;Me++){let Re=fe[Me];_t(Re,W,V),$.add(Re)}else _t(fe,W,V),$.add(fe)}),p=w.pop(),$},this.compileAsync=function(S,z,W=null){let $=this.compile(S,z,W);return new Promise(V=>{function fe(){if($.forEach(function(Me){Pe.get(Me).currentProgram.isReady()&&$.delete(Me)}),$.size===0){V(S);return}setTimeout(fe,10)}rt.get("KHR_parallel_shader_compile")!==null?fe():setTimeout(fe,10)})};let Qt=null;function Lt(S){Qt&&Qt(S)}function On(){Pn.stop()}function Pi(){Pn.start()}let Pn=new Vm;Pn.setAnimationLoop(Lt),typeof self<"u"&&Pn.setContext(self),this.setAnimationLoop=function(S){Qt=S,re.setAnimationLoop(S),S===null?Pn.stop():Pn.start()},re.addEventListener("sessionstart",On),re.addEventListener("sessionend",Pi),this.render=function(S,z){if(z!==void 0&&z.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(F===!0)return;if(S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),re.enabled===!0&&re.isPresenting===!0&&(re.cameraAutoUpdate===!0&&re.updateCamera(z),z=re.getCamera()),S.isScene===!0&&S.onBeforeRender(y,S,z,B),p=me.get(S,w.length),p.init(z),w.push(p),De.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),Q.setFromProjectionMatrix(De),_e=this.localClippingEnabled,he=Ie.init(this.clippingPlanes,_e),m=Fe.get(S,E.length),m.init(),E.push(m),re.enabled===!0&&re.isPresenting===!0){let fe=y.xr.getDepthSensingMesh();fe!==null&&gn(fe,z,-1/0,y.sortObjects)}gn(S,z,0,y.sortObjects),m.finish(),y.sortObjects===!0&&m.sort(ce,le),ft=re.enabled===!1||re.isPresenting===!1||re.hasDepthSensing()===!1,ft&&ie.addToRenderList(m,S),this.info.render.frame++,he===!0&&Ie.beginShadows();let W=p.state.shadowsArray;Ee.render(W,S,z),he===!0&&Ie.endShadows(),this.info.autoReset===!0&&this.info.reset();let $=m.opaque,V=m.transmissive;if(p.setupLights(),z.isArrayCamera){let fe=z.cameras;if(V.length>0)for(let Me=0,Re=fe.length;Me<Re;Me++){let Ce=fe[Me];Li($,V,S,Ce)}ft&&ie.render(S);for(let Me=0,Re=fe.length;Me<Re;Me++){let Ce=fe[Me];Ii(m,S,Ce,Ce.viewport)}}else V.length>0&&Li($,V,S,z),ft&&ie.render(S),Ii(m,S,z);B!==null&&L===0&&($e.updateMultisampleRenderTarget(B),$e.updateRenderTargetMipmap(B)),S.isScene===!0&&S.onAfterRender(y,S,z),We.resetDefaultState(),T=-1,b=null,w.pop(),w.length>0?(p=w[w.length-1],he===!0&&Ie.setGlobalState(y.clippingPlanes,p.state.camera)):p=null,E.pop(),E.length>0?m=E[E.length-1]:m=null};function gn(S,z,W,$){if(S.visible===!1)return;if(S.layers.test(z.layers)){if(S.isGroup)W=S.renderOrder;else if(S.isLOD)S.autoUpdate===!0&&S.update(z);else if(S.isLight)p.pushLight(S),S.castShadow&&p.pushShadow(S);else if(S.isSprite){if(!S.frustumCulled||Q.intersectsSprite(S)){$&&Te.setFromMatrixPosition(S.matrixWorld).applyMatrix4(De);let Me=Z.update(S),Re=S.material;Re.visible&&m.push(S,Me,Re,W,Te.z,null)}}else if((S.isMesh||S.isLine||S.isPoints)&&(!S.frustumCulled||Q.intersectsObject(S))){let Me=Z.update(S),Re=S.material;if($&&(S.boundingSphere!==void 0?(S.boundingSphere===null&&S.computeBoundingSphere(),Te.copy(S.boundingSphere.center)):(Me.boundingSphere===null&&Me.computeBoundingSphere(),Te.copy(Me.boundingSphere.center)),Te.applyMatrix4(S.matrixWorld).applyMatrix4(De)),Array.isArray(Re)){let Ce=Me.groups;for(let Xe=0,qe=Ce.length;Xe<qe;Xe++){let ze=Ce[Xe],nt=Re[ze.materialIndex];nt&&nt.visible&&m.push(S,Me,nt,W,Te.z,ze)}}else Re.visible&&m.push(S,Me,Re,W,Te.z,null)}}let fe=S.children;for(let Me=0,Re=fe.length;Me<Re;Me++)gn(fe[Me],z,W,$)}function Ii(S,z,W,$){let V=S.opaque,fe=S.transmissive,Me=S.transparent;p.setupLightsView(W),he===!0&&Ie.setGlobalState(y.clippingPlanes,W),$&&Oe.viewport(R.copy($)),V.length>0&&bs(V,z,W),fe.length>0&&bs(fe,z,W),Me.length>0&&bs(Me,z,W),Oe.buffers.depth.setTest(!0),Oe.buffers.depth.setMask(!0),Oe.buffers.color.setMask(!0),Oe.setPolygonOffset(!1)}function Li(S,z,W,$){if((W.isScene===!0?W.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[$.id]===void 0&&(p.state.transmissionRenderTarget[$.id]=new Si(1,1,{generateMipmaps:!0,type:rt.has("EXT_color_buffer_half_float")||rt.has("EXT_color_buffer_float")?Xr:Ai,minFilter:vs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ct.workingColorSpace}));let fe=p.state.transmissionRenderTarget[$.id],Me=$.viewport||R;fe.setSize(Me.z*y.transmissionResolutionScale,Me.w*y.transmissionResolutionScale);let Re=y.getRenderTarget(),Ce=y.getActiveCubeFace(),Xe=y.getActiveMipmapLevel();y.setRenderTarget(fe),y.getClearColor(G),Y=y.getClearAlpha(),Y<1&&y.setClearColor(16777215,.5),y.clear(),ft&&ie.render(W);let qe=y.toneMapping;y.toneMapping=$i;let ze=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),p.setupLightsView($),he===!0&&Ie.setGlobalState(y.clippingPlanes,$),bs(S,W,$),$e.updateMultisampleRenderTarget(fe),$e.updateRenderTargetMipmap(fe),rt.has("WEBGL_multisampled_render_to_texture")===!1){let nt=!1;for(let pt=0,Dt=z.length;pt<Dt;pt++){let it=z[pt],Mt=it.object,Ge=it.geometry,Ct=it.material,lt=it.group;if(Ct.side===Ei&&Mt.layers.test($.layers)){let Mn=Ct.side;Ct.side=Rn,Ct.needsUpdate=!0,Qr(Mt,W,$,Ge,Ct,lt),Ct.side=Mn,Ct.needsUpdate=!0,nt=!0}}nt===!0&&($e.updateMultisampleRenderTarget(fe),$e.updateRenderTargetMipmap(fe))}y.setRenderTarget(Re,Ce,Xe),y.setClearColor(G,Y),ze!==void 0&&($.viewport=ze),y.toneMapping=qe}function bs(S,z,W){let $=z.isScene===!0?z.overrideMaterial:null;for(let V=0,fe=S.length;V<fe;V++){let Me=S[V],Re=Me.object,Ce=Me.geometry,Xe=Me.group,qe=Me.material;qe.allowOverride===!0&&$!==null&&(qe=$),Re.layers.test(W.layers)&&Qr(Re,z,W,Ce,qe,Xe)}}function Qr(S,z,W,$,V,fe){S.onBeforeRender(y,z,W,$,V,fe),S.modelViewMatrix.multiplyMatrices(W.matrixWorldInverse,S.matrixWorld),S.normalMatrix.getNormalMatrix(S.modelViewMatrix),V.onBeforeRender(y,z,W,$,S,fe),V.transparent===!0&&V.side===Ei&&V.forceSinglePass===!1?(V.side=Rn,V.needsUpdate=!0,y.renderBufferDirect(W,z,$,V,S,fe),V.side=Wi,V.needsUpdate=!0,y.renderBufferDirect(W,z,$,V,S,fe),V.side=Ei):y.renderBufferDirect(W,z,$,V,S,fe),S.onAfterRender(y,z,W,$,V,fe)}function tr(S,z,W){z.isScene!==!0&&(z=ut);let $=Pe.get(S),V=p.state.lights,fe=p.state.shadowsArray,Me=V.state.version,Re=te.getParameters(S,V.state,fe,z,W),Ce=te.getProgramCacheKey(Re),Xe=$.programs;$.environment=S.isMeshStandardMaterial?z.environment:null,$.fog=z.fog,$.envMap=(S.isMeshStandardMaterial?P:St).get(S.envMap||$.environment),$.envMapRotation=$.environment!==null&&S.envMap===null?z.environmentRotation:S.envMapRotation,Xe===void 0&&(S.addEventListener("dispose",Ne),Xe=new Map,$.programs=Xe);let qe=Xe.get(Ce);if(qe!==void 0){if($.currentProgram===qe&&$.lightsStateVersion===Me)return di(S,Re),qe}else Re.uniforms=te.getUniforms(S),S.onBeforeCompile(Re,y),qe=te.acquireProgram(Re,Ce),Xe.set(Ce,qe),$.uniforms=Re.uniforms;let ze=$.uniforms;return(!S.isShaderMaterial&&!S.isRawShaderMaterial||S.clipping===!0)&&(ze.clippingPlanes=Ie.uniform),di(S,Re),$.needsLights=ta(S),$.lightsStateVersion=Me,$.needsLights&&(ze.ambientLightColor.value=V.state.ambient,ze.lightProbe.value=V.state.probe,ze.directionalLights.value=V.state.directional,ze.directionalLightShadows.value=V.state.directionalShadow,ze.spotLights.value=V.state.spot,ze.spotLightShadows.value=V.state.spotShadow,ze.rectAreaLights.value=V.state.rectArea,ze.ltc_1.value=V.state.rectAreaLTC1,ze.ltc_2.value=V.state.rectAreaLTC2,ze.pointLights.value=V.state.point,ze.pointLightShadows.value=V.state.pointShadow,ze.hemisphereLights.value=V.state.hemi,ze.directionalShadowMap.value=V.state.directionalShadowMap,ze.directionalShadowMatrix.value=V.state.directionalShadowMatrix,ze.spotShadowMap.value=V.state.spotShadowMap,ze.spotLightMatrix.value=V.state.spotLightMatrix,ze.spotLightMap.value=V.state.spotLightMap,ze.pointShadowMap.value=V.state.pointShadowMap,ze.pointShadowMatrix.value=V.state.pointShadowMatrix),$.currentProgram=qe,$.uniformsList=null,qe}function ea(S){if(S.uniformsList===null){let z=S.currentProgram.getUniforms();S.uniformsList=Kr.seqWithValue(z.seq,S.uniforms)}return S.uniformsList}function di(S,z){let W=Pe.get(S);W.outputColorSpace=z.outputColorSpace,W.batching=z.batching,W.batchingColor=z.batchingColor,W.instancing=z.instancing,W.instancingColor=z.instancingColor,W.instancingMorph=z.instancingMorph,W.skinning=z.skinning,W.morphTargets=z.morphTargets,W.morphNormals=z.morphNormals,W.morphColors=z.morphColors,W.morphTargetsCount=z.morphTargetsCount,W.numClippingPlanes=z.numClippingPlanes,W.numIntersection=z.numClipIntersection,W.vertexAlphas=z.vertexAlphas,W.vertexTangents=z.vertexTangents,W.toneMapping=z.toneMapping}function dc(S,z,W,$,V){z.isScene!==!0&&(z=ut),$e.resetTextureUnits();let fe=z.fog,Me=$.isMeshStandardMaterial?z.environment:null,Re=B===null?y.outputColorSpace:B.isXRRenderTarget===!0?B.texture.colorSpace:Ws,Ce=($.isMeshStandardMaterial?P:St).get($.envMap||Me),Xe=$.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,qe=!!W.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),ze=!!W.morphAttributes.position,nt=!!W.morphAttributes.normal,pt=!!W.morphAttributes.color,Dt=$i;$.toneMapped&&(B===null||B.isXRRenderTarget===!0)&&(Dt=y.toneMapping);let it=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,Mt=it!==void 0?it.length:0,Ge=Pe.get($),Ct=p.state.lights;if(he===!0&&(_e===!0||S!==b)){let tn=S===b&&$.id===T;Ie.setState($,S,tn)}let lt=!1;$.version===Ge.__version?(Ge.needsLights&&Ge.lightsStateVersion!==Ct.state.version||Ge.outputColorSpace!==Re||V.isBatchedMesh&&Ge.batching===!1||!V.isBatchedMesh&&Ge.batching===!0||V.isBatchedMesh&&Ge.batchingColor===!0&&V.colorTexture===null||V.isBatchedMesh&&Ge.batchingColor===!1&&V.colorTexture!==null||V.isInstancedMesh&&Ge.instancing===!1||!V.isInstancedMesh&&Ge.instancing===!0||V.isSkinnedMesh&&Ge.skinning===!1||!V.isSkinnedMesh&&Ge.skinning===!0||V.isInstancedMesh&&Ge.instancingColor===!0&&V.instanceColor===null||V.isInstancedMesh&&Ge.instancingColor===!1&&V.instanceColor!==null||V.isInstancedMesh&&Ge.instancingMorph===!0&&V.morphTexture===null||V.isInstancedMesh&&Ge.instancingMorph===!1&&V.morphTexture!==null||Ge.envMap!==Ce||$.fog===!0&&Ge.fog!==fe||Ge.numClippingPlanes!==void 0&&(Ge.numClippingPlanes!==Ie.numPlanes||Ge.numIntersection!==Ie.numIntersection)||Ge.vertexAlphas!==Xe||Ge.vertexTangents!==qe||Ge.morphTargets!==ze||Ge.morphNormals!==nt||Ge.morphColors!==pt||Ge.toneMapping!==Dt||Ge.morphTargetsCount!==Mt)&&(lt=!0):(lt=!0,Ge.__version=$.version);let Mn=Ge.currentProgram;lt===!0&&(Mn=tr($,z,V));let Ji=!1,bn=!1,Ki=!1,Rt=Mn.getUniforms(),In=Ge.uniforms;if(Oe.useProgram(Mn.program)&&(Ji=!0,bn=!0,Ki=!0),$.id!==T&&(T=$.id,bn=!0),Ji||b!==S){Oe.buffers.depth.getReversed()?(oe.copy(S.projectionMatrix),dm(oe),pm(oe),Rt.setValue(U,"projectionMatrix",oe)):Rt.setValue(U,"projectionMatrix",S.projectionMatrix),Rt.setValue(U,"viewMatrix",S.matrixWorldInverse);let nn=Rt.map.cameraPosition;nn!==void 0&&nn.setValue(U,Je.setFromMatrixPosition(S.matrixWorld)),dt.logarithmicDepthBuffer&&Rt.setValue(U,"logDepthBufFC",2/(Math.log(S.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&Rt.setValue(U,"isOrthographic",S.isOrthographicCamera===!0),b!==S&&(b=S,bn=!0,Ki=!0)}if(V.isSkinnedMesh){Rt.setOptional(U,V,"bindMatrix"),Rt.setOptional(U,V,"bindMatrixInverse");let tn=V.skeleton;tn&&(tn.boneTexture===null&&tn.computeBoneTexture(),Rt.setValue(U,"boneTexture",tn.boneTexture,$e))}V.isBatchedMesh&&(Rt.setOptional(U,V,"batchingTexture"),Rt.setValue(U,"batchingTexture",V._matricesTexture,$e),Rt.setOptional(U,V,"batchingIdTexture"),Rt.setValue(U,"batchingIdTexture",V._indirectTexture,$e),Rt.setOptional(U,V,"batchingColorTexture"),V._colorsTexture!==null&&Rt.setValue(U,"batchingColorTexture",V._colorsTexture,$e));let Sn=W.morphAttributes;if((Sn.position!==void 0||Sn.normal!==void 0||Sn.color!==void 0)&&xe.update(V,W,Mn),(bn||Ge.receiveShadow!==V.receiveShadow)&&(Ge.receiveShadow=V.receiveShadow,Rt.setValue(U,"receiveShadow",V.receiveShadow)),$.isMeshGouraudMaterial&&$.envMap!==null&&(In.envMap.value=Ce,In.flipEnvMap.value=Ce.isCubeTexture&&Ce.isRenderTargetTexture===!1?-1:1),$.isMeshStandardMaterial&&$.envMap===null&&z.environment!==null&&(In.envMapIntensity.value=z.environmentIntensity),bn&&(Rt.setValue(U,"toneMappingExposure",y.toneMappingExposure),Ge.needsLights&&Ss(In,Ki),fe&&$.fog===!0&&ee.refreshFogUniforms(In,fe),ee.refreshMaterialUniforms(In,$,j,K,p.state.transmissionRenderTarget[S.id]),Kr.upload(U,ea(Ge),In,$e)),$.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(Kr.upload(U,ea(Ge),In,$e),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&Rt.setValue(U,"center",V.center),Rt.setValue(U,"modelViewMatrix",V.modelViewMatrix),Rt.setValue(U,"normalMatrix",V.normalMatrix),Rt.setValue(U,"modelMatrix",V.matrixWorld),$.isShaderMaterial||$.isRawShaderMaterial){let tn=$.uniformsGroups;for(let nn=0,ji=tn.length;nn<ji;nn++){let Di=tn[nn];N.update(Di,Mn),N.bind(Di,Mn)}}return Mn}function Ss(S,z){S.ambientLightColor.needsUpdate=z,S.lightProbe.needsUpdate=z,S.directionalLights.needsUpdate=z,S.directionalLightShadows.needsUpdate=z,S.pointLights.needsUpdate=z,S.pointLightShadows.needsUpdate=z,S.spotLights.needsUpdate=z,S.spotLightShadows.needsUpdate=z,S.rectAreaLights.needsUpdate=z,S.hemisphereLights.needsUpdate=z}function ta(S){return S.isMeshLambertMaterial||S.isMeshToonMaterial||S.isMeshPhongMaterial||S.isMeshStandardMaterial||S.isShadowMaterial||S.isShaderMaterial&&S.lights===!0}this.getActiveCubeFace=function(){return I},this.getActiveMipmapLevel=function(){return L},this.getRenderTarget=function(){return B},this.setRenderTargetTextures=function(S,z,W){let $=Pe.get(S);$.__autoAllocateDepthBuffer=S.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Pe.get(S.texture).__webglTexture=z,Pe.get(S.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:W,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(S,z){let W=Pe.get(S);W.__webglFramebuffer=z,W.__useDefaultFramebuffer=z===void 0};let pi=U.createFramebuffer();this.setRenderTarget=function(S,z=0,W=0){B=S,I=z,L=W;let $=!0,V=null,fe=!1,Me=!1;if(S){let Ce=Pe.get(S);if(Ce.__useDefaultFramebuffer!==void 0)Oe.bindFramebuffer(U.FRAMEBUFFER,null),$=!1;else if(Ce.__webglFramebuffer===void 0)$e.setupRenderTarget(S);else if(Ce.__hasExternalTextures)$e.rebindTextures(S,Pe.get(S.texture).__webglTexture,Pe.get(S.depthTexture).__webglTexture);else if(S.depthBuffer){let ze=S.depthTexture;if(Ce.__boundDepthTexture!==ze){if(ze!==null&&Pe.has(ze)&&(S.width!==ze.image.width||S.height!==ze.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(S)}}let Xe=S.texture;(Xe.isData3DTexture||Xe.isDataArrayTexture||Xe.isCompressedArrayTexture)&&(Me=!0);let qe=Pe.get(S).__webglFramebuffer;S.isWebGLCubeRenderTarget?(Array.isArray(qe[z])?V=qe[z][W]:V=qe[z],fe=!0):S.samples>0&&$e.useMultisampledRTT(S)===!1?V=Pe.get(S).__webglMultisampledFramebuffer:Array.isArray(qe)?V=qe[W]:V=qe,R.copy(S.viewport),X.copy(S.scissor),k=S.scissorTest}else R.copy(ge).multiplyScalar(j).floor(),X.copy(be).multiplyScalar(j).floor(),k=pe;if(W!==0&&(V=pi),Oe.bindFramebuffer(U.FRAMEBUFFER,V)&&$&&Oe.drawBuffers(S,V),Oe.viewport(R),Oe.scissor(X),Oe.setScissorTest(k),fe){let Ce=Pe.get(S.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ce.__webglTexture,W)}else if(Me){let Ce=Pe.get(S.texture),Xe=z;U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,Ce.__webglTexture,W,Xe)}else if(S!==null&&W!==0){let Ce=Pe.get(S.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Ce.__webglTexture,W)}T=-1},this.readRenderTargetPixels=function(S,z,W,$,V,fe,Me,Re=0){if(!(S&&S.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ce=Pe.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&Me!==void 0&&(Ce=Ce[Me]),Ce){Oe.bindFramebuffer(U.FRAMEBUFFER,Ce);try{let Xe=S.textures[Re],qe=Xe.format,ze=Xe.type;if(!dt.textureFormatReadable(qe)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!dt.textureTypeReadable(ze)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=S.width-$&&W>=0&&W<=S.height-V&&(S.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Re),U.readPixels(z,W,$,V,ve.convert(qe),ve.convert(ze),fe))}finally{let Xe=B!==null?Pe.get(B).__webglFramebuffer:null;Oe.bindFramebuffer(U.FRAMEBUFFER,Xe)}}},this.readRenderTargetPixelsAsync=async function(S,z,W,$,V,fe,Me,Re=0){if(!(S&&S.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ce=Pe.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&Me!==void 0&&(Ce=Ce[Me]),Ce)if(z>=0&&z<=S.width-$&&W>=0&&W<=S.height-V){Oe.bindFramebuffer(U.FRAMEBUFFER,Ce);let Xe=S.textures[Re],qe=Xe.format,ze=Xe.type;if(!dt.textureFormatReadable(qe))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!dt.textureTypeReadable(ze))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let nt=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,nt),U.bufferData(U.PIXEL_PACK_BUFFER,fe.byteLength,U.STREAM_READ),S.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Re),U.readPixels(z,W,$,V,ve.convert(qe),ve.convert(ze),0);let pt=B!==null?Pe.get(B).__webglFramebuffer:null;Oe.bindFramebuffer(U.FRAMEBUFFER,pt);let Dt=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await fm(U,Dt,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,nt),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,fe),U.deleteBuffer(nt),U.deleteSync(Dt),fe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(S,z=null,W=0){let $=Math.pow(2,-W),V=Math.floor(S.image.width*$),fe=Math.floor(S.image.height*$),Me=z!==null?z.x:0,Re=z!==null?z.y:0;$e.setTexture2D(S,0),U.copyTexSubImage2D(U.TEXTURE_2D,W,0,0,Me,Re,V,fe),Oe.unbindTexture()};let en=U.createFramebuffer(),qt=U.createFramebuffer();this.copyTextureToTexture=function(S,z,W=null,$=null,V=0,fe=null){fe===null&&(V!==0?(Xs("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),fe=V,V=0):fe=0);let Me,Re,Ce,Xe,qe,ze,nt,pt,Dt,it=S.isCompressedTexture?S.mipmaps[fe]:S.image;if(W!==null)Me=W.max.x-W.min.x,Re=W.max.y-W.min.y,Ce=W.isBox3?W.max.z-W.min.z:1,Xe=W.min.x,qe=W.min.y,ze=W.isBox3?W.min.z:0;else{let Sn=Math.pow(2,-V);Me=Math.floor(it.width*Sn),Re=Math.floor(it.height*Sn),S.isDataArrayTexture?Ce=it.depth:S.isData3DTexture?Ce=Math.floor(it.depth*Sn):Ce=1,Xe=0,qe=0,ze=0}$!==null?(nt=$.x,pt=$.y,Dt=$.z):(nt=0,pt=0,Dt=0);let Mt=ve.convert(z.format),Ge=ve.convert(z.type),Ct;z.isData3DTexture?($e.setTexture3D(z,0),Ct=U.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?($e.setTexture2DArray(z,0),Ct=U.TEXTURE_2D_ARRAY):($e.setTexture2D(z,0),Ct=U.TEXTURE_2D),U.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,z.flipY),U.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),U.pixelStorei(U.UNPACK_ALIGNMENT,z.unpackAlignment);let lt=U.getParameter(U.UNPACK_ROW_LENGTH),Mn=U.getParameter(U.UNPACK_IMAGE_HEIGHT),Ji=U.getParameter(U.UNPACK_SKIP_PIXELS),bn=U.getParameter(U.UNPACK_SKIP_ROWS),Ki=U.getParameter(U.UNPACK_SKIP_IMAGES);U.pixelStorei(U.UNPACK_ROW_LENGTH,it.width),U.pixelStorei(U.UNPACK_IMAGE_HEIGHT,it.height),U.pixelStorei(U.UNPACK_SKIP_PIXELS,Xe),U.pixelStorei(U.UNPACK_SKIP_ROWS,qe),U.pixelStorei(U.UNPACK_SKIP_IMAGES,ze);let Rt=S.isDataArrayTexture||S.isData3DTexture,In=z.isDataArrayTexture||z.isData3DTexture;if(S.isDepthTexture){let Sn=Pe.get(S),tn=Pe.get(z),nn=Pe.get(Sn.__renderTarget),ji=Pe.get(tn.__renderTarget);Oe.bindFramebuffer(U.READ_FRAMEBUFFER,nn.__webglFramebuffer),Oe.bindFramebuffer(U.DRAW_FRAMEBUFFER,ji.__webglFramebuffer);for(let Di=0;Di<Ce;Di++)Rt&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Pe.get(S).__webglTexture,V,ze+Di),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Pe.get(z).__webglTexture,fe,Dt+Di)),U.blitFramebuffer(Xe,qe,Me,Re,nt,pt,Me,Re,U.DEPTH_BUFFER_BIT,U.NEAREST);Oe.bindFramebuffer(U.READ_FRAMEBUFFER,null),Oe.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(V!==0||S.isRenderTargetTexture||Pe.has(S)){let Sn=Pe.get(S),tn=Pe.get(z);Oe.bindFramebuffer(U.READ_FRAMEBUFFER,en),Oe.bindFramebuffer(U.DRAW_FRAMEBUFFER,qt);for(let nn=0;nn<Ce;nn++)Rt?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Sn.__webglTexture,V,ze+nn):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Sn.__webglTexture,V),In?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,tn.__webglTexture,fe,Dt+nn):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,tn.__webglTexture,fe),V!==0?U.blitFramebuffer(Xe,qe,Me,Re,nt,pt,Me,Re,U.COLOR_BUFFER_BIT,U.NEAREST):In?U.copyTexSubImage3D(Ct,fe,nt,pt,Dt+nn,Xe,qe,Me,Re):U.copyTexSubImage2D(Ct,fe,nt,pt,Xe,qe,Me,Re);Oe.bindFramebuffer(U.READ_FRAMEBUFFER,null),Oe.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else In?S.isDataTexture||S.isData3DTexture?U.texSubImage3D(Ct,fe,nt,pt,Dt,Me,Re,Ce,Mt,Ge,it.data):z.isCompressedArrayTexture?U.compressedTexSubImage3D(Ct,fe,nt,pt,Dt,Me,Re,Ce,Mt,it.data):U.texSubImage3D(Ct,fe,nt,pt,Dt,Me,Re,Ce,Mt,Ge,it):S.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,fe,nt,pt,Me,Re,Mt,Ge,it.data):S.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,fe,nt,pt,it.width,it.height,Mt,it.data):U.texSubImage2D(U.TEXTURE_2D,fe,nt,pt,Me,Re,Mt,Ge,it);U.pixelStorei(U.UNPACK_ROW_LENGTH,lt),U.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Mn),U.pixelStorei(U.UNPACK_SKIP_PIXELS,Ji),U.pixelStorei(U.UNPACK_SKIP_ROWS,bn),U.pixelStorei(U.UNPACK_SKIP_IMAGES,Ki),fe===0&&z.generateMipmaps&&U.generateMipmap(Ct),Oe.unbindTexture()},this.copyTextureToTexture3D=function(S,z,W=null,$=null,V=0){return Xs('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(S,z,W,$,V)},this.initRenderTarget=function(S){Pe.get(S).__webglFramebuffer===void 0&&$e.setupRenderTarget(S)},this.initTexture=function(S){S.isCubeTexture?$e.setTextureCube(S,0):S.isData3DTexture?$e.setTexture3D(S,0):S.isDataArrayTexture||S.isCompressedArrayTexture?$e.setTexture2DArray(S,0):$e.setTexture2D(S,0),Oe.unbindTexture()},this.resetState=function(){I=0,L=0,B=null,Oe.reset(),We.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Mi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=ct._getDrawingBufferColorSpace(e),t.unpackColorSpace=ct._getUnpackColorSpace()}};var Vb=`precision highp float;
in vec2 position; in float value; in float held;
uniform vec4 view;  // middle, factors to clip space
out float v_value; out float v_held;
void main() { v_value = value; v_held = held; gl_Position = vec4((position - view.xy) * view.zw, 0.0, 1.0); }`,Hb=`precision highp float;
in float v_value; in float v_held;
uniform vec2 range; uniform sampler2D colours; uniform float names; uniform vec3 ground; uniform vec3 hatch; uniform float pixel;
out vec4 colour;
void main() {
  if (v_held > 0.5) {
    float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 9.0 * pixel);
    colour = vec4(stripe < 1.2 * pixel ? hatch : ground, 1.0);
    return;
  }
  float x = names > 0.5 ? (mod(floor(v_value + 0.5), names) + 0.5) / 256.0
                        : (0.5 + 255.0 * clamp((v_value - range.x) / (range.y - range.x), 0.0, 1.0)) / 256.0;
  colour = vec4(texture(colours, vec2(x, 0.5)).rgb, 1.0);
}`,Gb=`precision highp float;
in vec2 position; in vec4 ends; in vec3 tint;
uniform vec4 view; uniform vec2 size; uniform float width;
out vec3 v_tint;
void main() {
  vec2 a = (ends.xy - view.xy) * view.zw, b = (ends.zw - view.xy) * view.zw;
  vec2 along = (b - a) * size;
  float length_ = max(length(along), 1e-6);
  vec2 across = vec2(-along.y, along.x) / length_;
  vec2 cap = along / length_ * (position.x - 0.5) * width;
  gl_Position = vec4(mix(a, b, position.x) + (across * position.y * width + cap) / size, 0.0, 1.0);
  v_tint = tint;
}`,Wb=`precision highp float;
in vec3 v_tint; uniform float opacity; uniform vec4 over; out vec4 colour;
void main() { colour = vec4(mix(v_tint, over.rgb, over.a), opacity); }`,qm=["original","joints","outline","crosses","contacts","supports","monitors","chosen"],Xb={original:1,joints:1.4,outline:1,crosses:1.2,contacts:2,supports:1.6,monitors:2,chosen:3},qb={original:.55,joints:.9,outline:.8,crosses:.95,contacts:1,supports:1,monitors:1,chosen:1},Yb=new Set(["crosses","contacts","supports","monitors"]),Pu=class{constructor(e,t,n,s,r){this.geometry=new Ho;this.empty=!0;this.shown=!0;this.geometry.setAttribute("position",new jt(new Float32Array([0,-1,1,-1,1,1,0,1]),2)),this.geometry.setIndex([0,1,2,0,2,3]);let o=(a,l,c)=>{let u=new Hr({glslVersion:$r,vertexShader:Gb,fragmentShader:Wb,transparent:!0,depthTest:!1,depthWrite:!1,side:2,uniforms:{view:{value:e},size:t,width:{value:a},opacity:{value:l},over:{value:c}}}),h=new Cn(this.geometry,u);return h.frustumCulled=!1,h};this.drawn=[...r?[o(n+2.4,.8,[1,1,1,1])]:[],o(n,s,[0,0,0,0])],this.set(new Float32Array(0),new Uint8Array(0))}set(e,t){let n=this.geometry.getAttribute("ends");n&&n.array.length===e.length&&e.length>0?(n.copyArray(e).needsUpdate=!0,this.geometry.getAttribute("tint").copyArray(t).needsUpdate=!0):(this.geometry.dispose(),this.geometry.setAttribute("ends",new Vr(e.slice(),4)),this.geometry.setAttribute("tint",new Vr(t.slice(),3,!0)));let s=e.length/4;this.geometry.instanceCount=s,this.empty=s===0,this.show(this.shown)}show(e){this.shown=e;for(let t of this.drawn)t.visible=e&&!this.empty}},lc=class i{constructor(e){this.canvas=e;this.view={x:0,y:0,scale:1};this.stage=new No;this.camera=new Gr;this.window=new zt;this.size={value:[1,1]};this.tables={magnitude:i.texture(ih("magnitude")),signed:i.texture(ih("signed"))};this.names=null;this.mesh=null;this.edges=new Uint32Array(0);this.edge_block=new Int32Array(0);this.edge_ends=new Float32Array(0);this.edge_tint=new Uint8Array(0);this.position=new Float32Array(0);this.theme=null;this.width=1;this.height=1;ct.enabled=!1,this.renderer=new oc({canvas:e,antialias:!0,preserveDrawingBuffer:!0}),this.renderer.sortObjects=!1,this.material=new Hr({glslVersion:$r,vertexShader:Vb,fragmentShader:Hb,depthTest:!1,depthWrite:!1,side:2,uniforms:{view:{value:this.window},range:{value:[0,1]},colours:{value:this.tables.magnitude},names:{value:0},ground:{value:[1,1,1]},hatch:{value:[0,0,0]},pixel:{value:1}}}),this.cells=new Cn(new ii,this.material),this.cells.frustumCulled=!1,this.stage.add(this.cells),this.lines=Object.fromEntries(qm.map(t=>[t,new Pu(this.window,this.size,Xb[t],qb[t],Yb.has(t))]));for(let t of qm)this.stage.add(...this.lines[t].drawn)}static texture(e){let t=new Oo(e,256,1,Nn);return t.minFilter=t.magFilter=Zn,t.needsUpdate=!0,t}use_theme(e){this.theme=e;let t=n=>n.map(s=>s/255);this.material.uniforms.ground.value=t(e.held),this.material.uniforms.hatch.value=t(e.hatch),this.renderer.setClearColor(e.ground[0]<<16|e.ground[1]<<8|e.ground[2],1),this.tint_edges()}resize(){let e=Math.min(3,globalThis.devicePixelRatio||1);this.width=Math.max(1,this.canvas.clientWidth),this.height=Math.max(1,this.canvas.clientHeight),this.renderer.outputColorSpace="srgb-linear",this.renderer.setPixelRatio(e),this.renderer.setSize(this.width,this.height,!1),this.size.value=[this.width,this.height],this.material.uniforms.pixel.value=e}use_mesh(e,t){this.mesh=e;let n=new ii,s=e.cells.length,r=new Float32Array(s);for(let a=0;a+1<e.offsets.length;++a)t(e.block[a])&&r.fill(1,e.offsets[a],e.offsets[a+1]);n.setAttribute("position",new jt(new Float32Array(2*s),2)),n.setAttribute("value",new jt(new Float32Array(s),1)),n.setAttribute("held",new jt(r,1)),n.setIndex(new jt(Wd(e),1)),this.cells.geometry.dispose(),this.cells.geometry=n,this.position=new Float32Array(e.origin.length);let o=Xd(e);this.edges=o.edges,this.edge_block=o.block,this.edge_ends=new Float32Array(2*this.edges.length),this.edge_tint=new Uint8Array(3*this.edge_block.length),this.tint_edges()}tint_edges(){if(this.theme)for(let e=0;e<this.edge_tint.length;++e)this.edge_tint[e]=this.theme.ink[e%3]}use_displacement(e,t){let n=this.mesh;for(let o=0;o<this.position.length;++o)this.position[o]=n.origin[o]+t*e[o];let s=this.cells.geometry.getAttribute("position"),r=s.array;for(let o=0;o<n.cells.length;++o){let a=n.cells[o];r[2*o]=this.position[2*a],r[2*o+1]=this.position[2*a+1]}s.needsUpdate=!0;for(let o=0;o<this.edges.length;++o){let a=this.edges[o];this.edge_ends[2*o]=this.position[2*a],this.edge_ends[2*o+1]=this.position[2*a+1]}this.lines.outline.set(this.edge_ends,this.edge_tint)}get values(){return this.cells.geometry.getAttribute("value").array}use_colours(e,t,n){if(this.cells.geometry.getAttribute("value").needsUpdate=!0,this.material.uniforms.range.value=t,this.material.uniforms.names.value=e.kind==="names"?Math.max(1,n.length):0,e.kind!=="names"){this.material.uniforms.colours.value=this.tables[e.kind];return}let s=new Uint8Array(4*256);n.slice(0,256).forEach((r,o)=>s.set([...r,255],4*o)),this.names?.dispose(),this.names=i.texture(s),this.material.uniforms.colours.value=this.names}use_lines(e,t,n){this.lines[e].set(t,n)}show(e,t){this.lines[e].show(t)}choose(e){let t=[];for(let s=0;s<this.edge_block.length;++s)this.edge_block[s]===e&&t.push(...this.edge_ends.subarray(4*s,4*s+4));let n=new Uint8Array(3*t.length/4);for(let s=0;s<n.length;++s)n[s]=[230,60,0][s%3];this.lines.chosen.set(new Float32Array(t),n)}fit(e,t,n,s){let[r,o,a]=[20,52,42],[l,c]=[Math.max(20,this.width-2*r),Math.max(20,this.height-o-a)];this.view.scale=Math.min(l/Math.max(n-e,1e-9),c/Math.max(s-t,1e-9)),this.view.x=.5*(e+n),this.view.y=.5*(t+s)+.5*(o-a)/this.view.scale}zoom(e,t,n){let[s,r]=this.place(t,n);this.view.scale*=e,this.view.x=s-(t-.5*this.width)/this.view.scale,this.view.y=r+(n-.5*this.height)/this.view.scale}place(e,t){return[this.view.x+(e-.5*this.width)/this.view.scale,this.view.y-(t-.5*this.height)/this.view.scale]}pixel(e,t){return[.5*this.width+(e-this.view.x)*this.view.scale,.5*this.height-(t-this.view.y)*this.view.scale]}render(){this.window.set(this.view.x,this.view.y,2*this.view.scale/this.width,2*this.view.scale/this.height),this.renderer.render(this.stage,this.camera)}};function hc(i){let e=new DataView(i.buffer,i.byteOffset,i.byteLength),t=e.getUint32(0,!0),n=new Map,s=4+24*t;for(let r=0;r<t;++r){let o=4+24*r,a="";for(let d=0;d<16&&i[o+d]!==0;++d)a+=String.fromCharCode(i[o+d]);let l=e.getUint32(o+16,!0),c=e.getUint32(o+20,!0),u=l===2?1:4;if(s+u*c>i.length)throw new Error(`array ${a} is cut short`);let h=i.subarray(s,s+u*c);if(s+=u*c,l===2){n.set(a,h.slice());continue}let f=new Uint8Array(4*c);for(let d=0;d<4;++d)for(let _=0,M=d*c;_<c;++_)f[4*_+d]=h[M+_];n.set(a,l===0?new Float32Array(f.buffer):new Int32Array(f.buffer))}return n}async function $b(i){if(typeof DecompressionStream>"u")throw new Error("this browser is too old to read a run: it takes Chrome 80, Firefox 113, Safari 16.4 or later");let e=new Blob([i]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(e).arrayBuffer())}function yn(i,e){let t=i.get(e);if(!t)throw new Error(`there is no array ${e}; the run is damaged`);return t}function Iu(i){return{origin:yn(i,"origin"),offsets:yn(i,"offsets"),cells:yn(i,"cells"),block:yn(i,"block"),material:yn(i,"material"),method:yn(i,"method")}}function Zb(i){return{displacement:yn(i,"displacement"),velocity:yn(i,"velocity"),stress:yn(i,"stress"),integrator:yn(i,"integrator"),contacts:i.has("c.state")?{position:yn(i,"c.position"),normal:yn(i,"c.normal"),force:yn(i,"c.force"),slip:yn(i,"c.slip"),blocks:yn(i,"c.blocks"),state:yn(i,"c.state")}:null}}var Lu=3e8,jo=class{constructor(e){this.run=e;this.meshes=new Map;this.frames=new Map;this.sizes=new Map;this.kept=0;if(e.format!==1)throw new Error(`the run has format ${e.format}, which this page cannot read`)}mesh(e){let t=this.meshes.get(e);return t||this.meshes.set(e,t=this.chunk(`mesh-${e}`).then(Iu)),t}frame(e){let t=this.frames.get(e);return t?this.frames.delete(e):(t=this.chunk(`frame-${e}`).then(Zb),t.then(n=>this.keep(e,4*(n.displacement.length+n.velocity.length+n.stress.length)),()=>this.frames.delete(e))),this.frames.set(e,t),t}async history(){return await this.chunk("history")}keep(e,t){this.sizes.set(e,t),this.kept+=t;for(let n of this.frames.keys()){if(this.kept<=Lu||n===e)break;this.kept-=this.sizes.get(n)??0,this.sizes.delete(n),this.frames.delete(n)}}async chunk(e){return hc(await $b(await this.packed(e)))}},cc=class extends jo{constructor(){super(JSON.parse(Ym("run")))}async packed(e){let t=atob(Ym(e)),n=new Uint8Array(t.length);for(let s=0;s<t.length;++s)n[s]=t.charCodeAt(s);return n}};function Ym(i){let e=document.getElementById(`scree-${i}`);if(!e||e.textContent===null)throw new Error(`the report lacks its part ${i}; it is damaged`);return e.textContent}var Jb=500,Kb=3,jb=new TextDecoder,uc=class i{constructor(e){this.waiting=e;this.live=this;this.scalar="speed";this.session=-1;this.connected=!1;this.last_status=null;this.socket=null;this.meshes=new Map;this.frames=[];this.bytes=0;this.rows=new Map;this.changed=()=>{};this.ready=()=>{}}static open(e){let t=new i(e);return new Promise(n=>{t.ready=n,t.connect()})}follow(e){this.changed=e}mesh(e){let t=this.meshes.get(e);return t?Promise.resolve(t):Promise.reject(new Error(`mesh ${e} has not come`))}frame(e){let t=this.frames[e];return t?Promise.resolve(t):Promise.reject(new Error(`frame ${e} has not come`))}history(){return Promise.resolve(new Map([...this.rows].map(([e,t])=>[e,Float32Array.from(t)])))}status(){if(!this.connected)return"connection to scree view lost; trying again";let e=this.last_status;if(!e)return"";let t=e.status==="running"||e.status==="paused",n=[e.status+(e.reason?`: ${e.reason}`:"")];return t&&e.silent>=Kb&&n.push(`silent for ${e.silent} s`),e.status==="running"&&e.rate>0&&n.push(`${Xt(e.rate)} s/s`),e.status==="running"&&e.time_left>=0&&n.push(`${Xt(e.time_left,2)} s left`),[...n,`${Wn(Math.max(e.time,this.run.frames.list[this.run.frames.list.length-1]?.time??0))} of ${Wn(e.end_time)}`].join(" \xB7 ")}connect(){let e=new URL("live",location.href);e.protocol="ws:",e.hash="";let t=this.socket=new WebSocket(e);t.binaryType="arraybuffer",t.onopen=()=>{this.connected=!0,this.changed(!1)},t.onmessage=n=>this.take(new Uint8Array(n.data)),t.onclose=()=>{this.connected=!1,this.frames.length===0?this.waiting("scree view does not answer; trying again"):this.changed(!1),setTimeout(()=>this.connect(),Jb)}}take(e){let t=new DataView(e.buffer,e.byteOffset).getUint32(0,!0),n=JSON.parse(jb.decode(e.subarray(4,4+t))),s=e.subarray(4+t);if(n.kind==="run"&&this.session>=0&&n.session!==this.session){location.reload();return}n.kind==="run"?this.take_run(n):n.kind==="status"?this.take_status(n):n.session===this.session&&(n.kind==="mesh"?this.take_mesh(n,s):n.kind==="rows"?this.take_rows(n):n.kind==="events"?this.run.events=n.list:n.kind==="frame"&&this.take_frame(n,s)),n.kind==="frame"&&this.socket?.send("n")}take_run(e){this.run||(this.session=e.session,this.scalar=e.field,this.run={format:1,written_by:e.version,title:e.title,folder:e.run,origin:e.origin,model:{blocks:[],materials:[],methods:[],supports:[],joints:{laws:[],lines:[],cracks:[]}},stages:[],frames:{list:[],stored:0,meshes:0,ranges:{},bounds:e.bounds},history:{monitors:[],ledger:[],whole:!0},contacts:!1,events:[],asked:{case:"",set:[],libraries:[],version:e.version},found:null});let{blocks:t,materials:n}=this.run.model;for(;t.length<e.blocks;)t.push({name:`block ${t.length+1}`,material:-1,held:!1,rings:[]});for(;n.length<e.materials;)n.push({name:`material ${n.length+1}`,density:NaN,young:NaN,poisson:NaN})}take_status(e){if(e.session<0){let t=e.run?`a run named ${e.run}`:"any run";this.waiting(e.trouble||`Nothing is heard of ${t} on ${e.url}: waiting. Does it stream? scree run CASE --live`);return}e.session===this.session&&(this.last_status=e,this.run.found={status:e.status,reason:e.reason??"",final_time:e.time,steps:e.steps,cuts:e.cuts,open_close_passes:e.passes,blocks_count:e.blocks,elements:e.elements,unknowns:e.unknowns,contacts:e.contacts},this.changed(!1))}take_mesh(e,t){let n=Iu(hc(t)),s=this.run.model.methods;for(let r of e.methods)s.includes(r)||s.push(r);n.method=n.method.map(r=>s.indexOf(e.methods[r]??""));for(let r=0;r<n.block.length;++r)this.run.model.blocks[n.block[r]].material=n.material[r];this.meshes.has(e.mesh)||this.meshes.set(e.mesh,n)}take_frame(e,t){let n=this.run.frames.list,s=n[n.length-1];if(!this.meshes.has(e.mesh)||s&&s.time===e.time&&s.mesh===e.mesh)return;let r=hc(t),o={displacement:r.get("displacement"),scalar:r.get("scalar"),velocity:new Float32Array(0),stress:new Float32Array(0),integrator:new Uint8Array(0),contacts:null};this.grow_ranges(o);let a=this.run.stages;a[a.length-1]?.name!==e.stage&&a.push({name:e.stage,integrator:e.integrator,duration:0,start:e.time}),n.push({index:n.length,time:e.time,step:e.step,mesh:e.mesh,stage:e.stage,integrator:e.integrator}),this.frames.push(o),this.bytes+=4*(o.displacement.length+o.scalar.length),this.run.frames.stored+=1;let l=this.bytes>Lu;l&&this.thin(),this.frames.length===1&&this.ready(this),this.changed(l)}grow_ranges(e){let t={displacement:0,ux:0,uy:0,scalar:0},n=e.displacement;for(let r=0;r+1<n.length;r+=2){let[o,a]=[Math.abs(n[r]),Math.abs(n[r+1])];o>t.ux&&(t.ux=o),a>t.uy&&(t.uy=a);let l=Math.hypot(o,a);l>t.displacement&&(t.displacement=l)}for(let r of e.scalar)Math.abs(r)>t.scalar&&(t.scalar=Math.abs(r));let s=this.run.frames.ranges;for(let[r,o]of Object.entries(t)){let a=Math.max(o,s[r]?.[1]??0),l=Us.find(c=>c.id===r)?.kind==="signed"||r==="scalar"&&this.scalar!=="speed";a>0&&(s[r]=[l?-a:0,a])}}thin(){let e=this.run.frames.list,t=r=>e[r].stage!==e[r-1]?.stage||e[r].stage!==e[r+1]?.stage||e[r].mesh!==e[r+1]?.mesh,n=e.map((r,o)=>o).filter(r=>r%2===0||r>.75*e.length||t(r));this.frames=n.map(r=>this.frames[r]);let s=n.map(r=>e[r]);e.splice(0,e.length,...s),this.bytes=this.frames.reduce((r,o)=>r+4*(o.displacement.length+o.scalar.length),0)}take_rows(e){let t=(o,...a)=>{let l=this.rows.get(o);l?l.push(...a):this.rows.set(o,a)},n=(o,a)=>!(a<=(this.rows.get(o)?.slice(-1)[0]??-1/0)),s=e.monitors;s&&s.list.length>0&&n("m0.time",s.time)&&(this.run.history.monitors=s.list.map(o=>({name:o.name,stress:!1,at:o.at})),s.list.forEach((o,a)=>{t(`m${a}.time`,s.time),t(`m${a}.u`,...o.u),t(`m${a}.v`,...o.v)}));let r=e.ledger;if(r&&n("l.time",r.time)){this.run.history.ledger=r.columns.map(o=>({name:o.name,side:o.side,meaning:""})),t("l.time",r.time);for(let o of["energy","closure","moved","passed"])t(`l.${o}`,r[o]);r.columns.forEach((o,a)=>t(`l.${a}`,o.value))}}};async function $m(i){let e=await fetch(i).catch(()=>{throw new Error("scree view does not answer; it has ended")});if(!e.ok)throw new Error((await e.text()).trim()||`the server answers with ${e.status}`);return e}var fc=class i extends jo{static async open(){return new i(await(await $m("run.json")).json())}async packed(e){return new Uint8Array(await(await $m(e.replace("-","/"))).arrayBuffer())}};var ke=i=>document.getElementById(i),Zm=matchMedia("(prefers-color-scheme: dark)"),Qb=26,eS=1e3,tS=1e3/12,nS=document.body.dataset.source!==void 0,iS="This is a live stream: what has come since the page was opened. Displacements are rounded to 16 bits of what the points of a block moved; blocks and materials have numbers, as the stream has no names of them.",Qo=document.body.dataset.source==="model";function Du(i){let e=ke("trouble");e.textContent=`This page cannot be shown: ${i instanceof Error?i.message:String(i)}`,e.hidden=!1}function Ms(i){let e=getComputedStyle(document.documentElement).getPropertyValue(i).trim();return[1,3,5].map(t=>parseInt(e.slice(t,t+2),16))}var Uu=class{constructor(e){this.source=e;this.charts=[];this.rows=new Map;this.mesh=null;this.mesh_index=-1;this.frame=null;this.index=-1;this.note=null;this.wanted=0;this.loading=!1;this.playing=!1;this.clock=0;this.last_tick=0;this.still=0;this.fields=Us;this.field=Us[0];this.following=!1;this.slow_asked=!1;this.pair=null;this.led=!1;this.events_shown=null;this.legend={what:"",ticks:[],names:[]};this.chosen=-1;this.scale_bar={pixels:0,text:""};this.labels=[];this.draw_asked=!1;this.own_view=!1;this.crosses=null;this.forces=null;this.shown={original:!0,joints:!1,outline:!0,crosses:!1,contacts:!1,supports:!0,monitors:!0,chosen:!0};this.block_chart=null;this.block_history=null;this.held=e=>this.run.model.blocks[e]?.held??!1;this.area_of=new WeakMap;this.monitor_chart=null;this.ledger_chart=null;this.closure_chart=null;this.run=e.run,this.frames=this.run.frames.list,e.live&&(this.fields=Nd(e.live.scalar));let t=null;try{t=new lc(ke("view"))}catch{Du("this browser has no WebGL 2, which the animation needs; histories and tables are below")}this.scene=t}async start(){this.pair=wa.find(e=>this.heard(e)),this.show_text(),this.fill_controls(),this.bind(),this.use_theme(),this.scene?.resize(),this.fit(),await this.go(this.source.live?this.frames.length-1:0),this.rows=await this.source.history(),this.make_charts(),this.redraw(),this.tell_extent(!0),this.source.live&&(this.set_following(!0),this.source.live.follow(e=>this.stream_changed(e))),document.body.dataset.ready="true"}tell_extent(e){let[t,n]=this.run.origin,[s,r,o,a]=this.run.frames.bounds;this.pair?.tell({ranges:this.run.frames.ranges,bounds:[s+t,r+n,o+t,a+n],...e?{hello:e}:{}})}heard(e){let[t,n]=this.run.origin,s=(r,o)=>{o!==void 0&&(ke(r).value=o)};if(e.ranges&&e.bounds){let r=this.run.frames,[o,a]=[r.bounds,e.bounds];r.ranges=sp(r.ranges,e.ranges),r.bounds=[Math.min(o[0],a[0]-t),Math.min(o[1],a[1]-n),Math.max(o[2],a[2]-t),Math.max(o[3],a[3]-n)],this.update_colours(),e.hello&&this.tell_extent(!1)}s("field",e.field),s("range",e.range),s("factor",e.factor),e.field!==void 0&&this.use_choices(),(e.fit||e.bounds)&&this.fit(!0),e.view&&this.scene&&(this.own_view=!0,Object.assign(this.scene.view,{x:e.view[0]-t,y:e.view[1]-n,scale:e.view[2]}),this.redraw(!0,!0)),e.time!==void 0&&(this.play(!1),this.led=!0,this.go(this.index_at(e.time)))}use_choices(){let e=ke("field");this.field=this.fields.find(t=>t.id===e.value)??this.fields[0],ke("range").disabled=this.field.kind==="names",this.update_places(),this.update_colours(),this.redraw()}choices_changed(){this.use_choices();let e=t=>ke(t).value;this.pair?.tell({field:e("field"),range:e("range"),factor:e("factor")})}set_following(e){this.following=e,ke("follow").setAttribute("aria-pressed",String(e)),e&&this.go(this.frames.length-1)}stream_changed(e){if(e&&this.note){let t=this.frames.indexOf(this.note);this.index=this.wanted=t>=0?t:Math.min(this.index,this.frames.length-1)}ke("time").max=String(this.frames.length-1),this.following&&this.go(this.frames.length-1),!this.slow_asked&&(this.slow_asked=!0,setTimeout(()=>{this.slow_asked=!1,this.refresh_texts()},eS))}async refresh_texts(){this.show_subtitle(),_h(this.run,ke("found")),this.events_shown!==this.run.events&&(this.events_shown=this.run.events,xh(this.run,ke("events"),e=>this.go_to_time(e))),this.mark_stages(),this.rows=await this.source.history(),this.make_charts(),this.update_colours(),this.redraw()}show_subtitle(){let e=this.run,t=this.frames[this.frames.length-1];ke("title").textContent=e.title||"Scree run";let n=e.model.blocks.filter(r=>r.held).length,s=this.source.live?[this.source.live.status()]:Qo?["before its run"]:[gh(e),`${Xt(t.time,4)} s simulated`];ke("subtitle").textContent=[...this.pair?[e.folder]:[],...s,`${e.model.blocks.length} blocks${n>0?`, ${n} of them held`:""}`,`${e.stages.length} ${e.stages.length===1?"stage":"stages"}`,`Scree ${String(e.asked.version??"")}`].join(" \xB7 ")}show_text(){let e=this.run;this.show_subtitle();let t=this.frames.length;ke("thinning").textContent=this.source.live?iS:[Qo?"This is the model before its run.":nS?`All ${t} stored frames are served as they are asked for; the range of colours is that of at most 300 of them.`:t<e.frames.stored?`${t} of the ${e.frames.stored} stored frames are in this file (scree report --size says how large it may be).`:`All ${t} stored frames are in this file.`,"Positions have 24 significant bits, velocities and stresses 12. Stress is recovered at the corners of elements, as in scree snapshot.",e.history.whole?"":"Histories are thinned in time.",e.contacts?"Of the contact points, those that are closed are here.":"The run stored no contacts (output.contacts)."].join(" "),ke("licences").textContent=document.getElementById("scree-licences")?.textContent??"",Qo?ke("found-box").hidden=ke("charts").hidden=ke("transport").hidden=!0:_h(e,ke("found")),ke("asked-box").hidden=this.source.live!==void 0,ke("follow").hidden=this.source.live===void 0,tp(e,ke("asked")),xh(e,ke("events"),n=>this.go_to_time(n))}fill_controls(){let e=(u,h,f)=>{let d=ke(u);for(let[_,M]of h){let m=Ze("option",M);m.value=_,d.append(m)}f!==void 0&&(d.value=f)};e("field",this.fields.map(u=>[u.id,u.label])),e("block",this.run.model.blocks.map((u,h)=>[String(h),u.name]));let t=this.source.live!==void 0;e("monitor-quantity",oh.filter(u=>!t||!u.includes("stress")).map(u=>[u,u])),e("block-quantity",oh.filter(u=>!t||u.includes("displacement")).map(u=>[u,u]));let n=this.frames[this.frames.length-1].time-this.frames[0].time,s=[.001,.01,.1,.25,.5,1,2,5,10,100,1e3],r=n>0?s.reduce((u,h)=>Math.abs(Math.log(h*10/n))<Math.abs(Math.log(u*10/n))?h:u,1):1;e("speed",s.map(u=>[String(u),u===1?"real time":`\xD7 ${u}`]),String(r));let o=ke("layers"),a=[["outline","outlines of the blocks"]];t||a.push(["original","original outline"],["joints","joints as drawn"],["crosses","principal stress crosses"]),this.run.model.supports.length>0&&a.push(["supports","point supports"]),(t||this.run.history.monitors.some(u=>u.at))&&a.push(["monitors","monitors"]),this.run.contacts&&a.push(["contacts","contact forces and states"]);let l=this.run.model.joints.lines.length+this.run.model.joints.cracks.length>0;for(let[u,h]of a){if(u==="joints"&&!l)continue;let f=Ze("label"),d=Ze("input");d.type="checkbox",d.id=`layer-${u}`,d.checked=this.shown[u],d.addEventListener("change",()=>{this.shown[u]=d.checked,this.scene?.show(u,d.checked),this.update_layers(),this.update_marks(),this.redraw()}),f.append(d,` ${h}`),o.append(f)}let c=ke("time");c.max=String(this.frames.length-1),this.mark_stages()}mark_stages(){let e=[];this.frames.forEach((n,s)=>{(s===0||n.stage!==this.frames[s-1].stage)&&e.push([s,n.stage])});let t=Math.max(1,this.frames.length-1);ke("stages").replaceChildren(),e.forEach(([n,s],r)=>{let o=Ze("span",s);o.title=s,o.style.left=`${100*n/t}%`,o.style.width=`${100*((e[r+1]?.[0]??t)-n)/t}%`,ke("stages").append(o)})}bind(){let e=(t,n,s)=>ke(t).addEventListener(n,s);e("play","click",()=>this.play(!this.playing)),e("follow","click",()=>(this.play(!1),this.set_following(!0))),e("back","click",()=>this.step(-1)),e("next","click",()=>this.step(1)),e("time","input",()=>this.seek(Number(ke("time").value))),e("zoom-in","click",()=>this.zoom(1.3)),e("zoom-out","click",()=>this.zoom(1/1.3)),e("fit","click",()=>this.fit()),e("save","click",()=>void this.save());for(let t of["field","range","factor"])e(t,"change",()=>this.choices_changed());e("block","change",()=>this.choose(Number(ke("block").value))),e("monitor-quantity","change",()=>this.draw_monitors()),e("block-quantity","change",()=>this.draw_block()),e("ledger-sides","change",()=>this.draw_ledger()),document.addEventListener("keydown",t=>this.key(t)),Zm.addEventListener("change",()=>(this.use_theme(),this.redraw())),this.scene&&(new ResizeObserver(()=>{this.scene.resize(),this.own_view?this.redraw(!0,!0):this.fit()}).observe(ke("picture")),this.bind_pointer(ke("view"),this.scene))}bind_pointer(e,t){let n=new Map,s=0;e.addEventListener("pointerdown",o=>{e.setPointerCapture(o.pointerId),n.set(o.pointerId,[o.offsetX,o.offsetY]),s=0}),e.addEventListener("pointermove",o=>{let[a,l]=t.place(o.offsetX,o.offsetY);ke("pointer").textContent=`x = ${(a+this.run.origin[0]).toFixed(2)} m, y = ${(l+this.run.origin[1]).toFixed(2)} m`;let c=n.get(o.pointerId);if(!c)return;let[u,h]=[o.offsetX-c[0],o.offsetY-c[1]];if(s+=Math.abs(u)+Math.abs(h),n.size===2){let f=[...n].find(([_])=>_!==o.pointerId)[1],d=(_,M)=>Math.hypot(_-f[0],M-f[1]);t.zoom(d(o.offsetX,o.offsetY)/Math.max(1,d(...c)),f[0],f[1])}else s>3&&(t.view.x-=u/t.view.scale,t.view.y+=h/t.view.scale);n.set(o.pointerId,[o.offsetX,o.offsetY]),s>3&&(this.own_view=!0),this.redraw(!0)});let r=o=>n.delete(o.pointerId);e.addEventListener("pointercancel",r),e.addEventListener("pointerleave",()=>ke("pointer").textContent=""),e.addEventListener("pointerup",o=>{if(r(o),s<=3&&this.mesh){let[a,l]=t.place(o.offsetX,o.offsetY),c=qd(this.mesh,t.position,a,l);this.choose(c<0?-1:this.mesh.block[c])}}),e.addEventListener("wheel",o=>{o.preventDefault(),t.zoom(Math.exp(-o.deltaY*(o.deltaMode===1?.05:.0015)),o.offsetX,o.offsetY),this.own_view=!0,this.redraw(!0)},{passive:!1})}key(e){if(e.ctrlKey||e.metaKey||e.altKey)return;let t=e.target;if(t.closest("input, select, textarea, pre, summary, .scroll"))return;let n=t.id==="view",s=(l,c)=>{let u=this.scene.view;u.x+=l*40/u.scale,u.y+=c*40/u.scale,this.own_view=!0,this.redraw(!0)},r={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};if(n&&this.scene&&r[e.key]){s(...r[e.key]),e.preventDefault();return}let a={" ":()=>this.play(!this.playing),ArrowLeft:()=>this.step(-1),ArrowRight:()=>this.step(1),Home:()=>this.seek(0),End:()=>this.seek(this.frames.length-1),"+":()=>this.zoom(1.3),"=":()=>this.zoom(1.3),"-":()=>this.zoom(1/1.3),0:()=>this.fit(),s:()=>void this.save(),S:()=>void this.save()}[e.key];!a||e.key===" "&&t.tagName==="BUTTON"||(e.preventDefault(),a())}step(e){this.seek(Math.min(this.frames.length-1,Math.max(0,this.wanted+e)))}seek(e){this.led=!1,this.play(!1),this.source.live&&this.set_following(!1),this.go(e).then(()=>this.say())}go_to_time(e){this.seek(this.index_at(e))}index_at(e){let t=0;return this.frames.forEach((n,s)=>{n.time<=e+1e-9&&(t=s)}),t}async go(e){if(this.wanted=e,!this.loading){this.loading=!0;try{for(;this.note!==this.frames[this.wanted];){let t=this.wanted,n=this.frames[t],[s,r]=await Promise.all([this.source.frame(t),this.source.mesh(n.mesh)]);this.mesh_index!==n.mesh&&(this.mesh=r,this.mesh_index=n.mesh,this.scene?.use_mesh(r,this.held)),this.frame=s,this.index=Math.max(0,this.frames.indexOf(n)),this.note=n,this.update_places(),this.update_colours(),this.show_instant(),this.redraw(),this.led||this.pair?.tell({time:n.time})}}catch(t){this.play(!1),Du(t)}finally{this.loading=!1}}}play(e){if(e===this.playing)return;e&&this.source.live&&this.set_following(!1),e&&(this.led=!1),this.playing=e;let t=ke("play");if(t.textContent=e?"Pause":"Play",t.setAttribute("aria-pressed",String(e)),!e)return this.say();this.wanted>=this.frames.length-1&&(this.wanted=0),this.clock=this.frames[this.wanted].time,this.last_tick=performance.now(),this.still=0;let n=s=>{if(!this.playing)return;let r=Math.min(250,Math.max(0,s-this.last_tick));this.last_tick=s,this.loading||this.advance(r),requestAnimationFrame(n)};requestAnimationFrame(n),this.go(this.wanted)}advance(e){let t=this.frames[this.wanted+1];if(!t)return this.play(!1);if(t.time<=this.frames[this.wanted].time){this.still+=e,this.still>=tS&&(this.still=0,this.go(this.wanted+1));return}this.clock+=e/1e3*Number(ke("speed").value);let n=this.wanted;for(;n+1<this.frames.length&&this.frames[n+1].time<=this.clock&&this.frames[n+1].time>this.frames[n].time;)++n;n!==this.wanted&&this.go(n);for(let s of[1,2])n+s<this.frames.length&&this.source.frame(n+s).catch(()=>{})}instant(){let e=this.frames[this.index];return`t = ${Wn(e.time)}, ${e.stage}`}show_instant(){let e=this.frames[this.index];ke("instant").textContent=this.instant();let t=ke("time");t.value=String(this.index),t.setAttribute("aria-valuetext",`${Wn(e.time)}, stage ${e.stage}, frame ${this.index+1} of ${this.frames.length}`),ke("view").setAttribute("aria-label",`The blocks at ${Wn(e.time)} in stage ${e.stage}, coloured by ${this.field.label}`);for(let n of this.charts)n.at(e.time);this.show_block_facts()}say(){this.index>=0&&(ke("said").textContent=this.instant())}use_theme(){if(this.scene?.use_theme({ground:Ms("--paper"),ink:Ms("--edge"),held:Ms("--held"),hatch:Ms("--hatch"),original:Ms("--original")}),!this.scene)return;let e=Kd(this.run,Ms("--original"));this.scene.use_lines("original",e.ends,e.tint);let t=ep(this.run);this.scene.use_lines("joints",t.ends,t.tint);for(let n of Object.keys(this.shown))this.scene.show(n,this.shown[n]);this.frame&&this.update_places()}factor(){return Number(ke("factor").value)}update_places(){!this.scene||!this.frame||(this.scene.use_displacement(this.frame.displacement,this.factor()),this.scene.choose(this.chosen),this.update_layers())}update_layers(){if(!(!this.scene||!this.frame||!this.mesh)){if(this.crosses=this.shown.crosses?Zd(this.mesh,this.frame,this.scene.position,this.held,Qb/this.scene.view.scale):null,this.crosses&&this.scene.use_lines("crosses",this.crosses.ends,this.crosses.tint),this.forces=null,this.shown.contacts&&this.frame.contacts){let[e,t,n,s]=this.run.frames.bounds;this.forces=Jd(this.frame.contacts,.08*Math.hypot(n-e,s-t)),this.scene.use_lines("contacts",this.forces.ends,this.forces.tint)}this.show_layer_key()}}update_marks(){if(!this.scene||this.index<0)return;let e=1/this.scene.view.scale,t=jd(this.run,Ms("--mark"),11*e);this.scene.use_lines("supports",t.ends,t.tint);let n=this.frames[this.index].time,s=[],r=[];this.labels=[],this.shown.monitors&&this.run.history.monitors.forEach((a,l)=>{let c=this.monitor_place(a.at,l,n);if(!c)return;s.push(c);let[u,h]=this.scene.pixel(...c),f=Ze("span",a.name);f.style.transform=`translate(${u+8}px, ${h-20}px)`,r.push(f),this.labels.push([a.name,u+12,h-11])}),ke("labels").replaceChildren(...r);let o=Qd(s,Ms("--mark"),5*e);this.scene.use_lines("monitors",o.ends,o.tint)}monitor_place(e,t,n){let s=this.rows.get(`m${t}.time`),r=this.rows.get(`m${t}.u`);if(!e||!s||!r||s.length===0)return null;let[o,a]=[0,s.length-1];for(;o<a;){let l=o+a+1>>1;s[l]<=n*(1+1e-6)+1e-9?o=l:a=l-1}return[e[0]+this.factor()*r[2*o],e[1]+this.factor()*r[2*o+1]]}show_layer_key(){let e=ke("layer-key");e.replaceChildren();let t=(n,s="")=>{let r=Ze("div");for(let[o,a]of n){let l=Ze("span",void 0,"swatch");l.style.background=rs(o),r.append(l,`${a}  `)}r.append(s),e.append(r)};if(this.run.model.blocks.some(n=>n.held)&&t([],"Hatched: held or driven as a whole."),this.shown.joints&&t(this.run.model.joints.laws.map((n,s)=>[Mr(s+3),n.name])),this.crosses&&this.crosses.stress>0&&t([[uh,"compression"],[fh,"tension"]],`\xB7 Longest arm: ${mn(this.crosses.stress,"Pa",2)}.`),this.forces){let n=this.forces;t([[dh,`sticking (${n.sticking})`],[ph,`slipping (${n.slipping})`],[mh,`slipping, strength failed (${n.failed})`]],n.force>0?`\xB7 Longest line: ${mn(n.force,"N",2)} for 1 m of thickness.`:"\xB7 No forces.")}}names(){return this.field.kind!=="names"?[]:this.field.names?this.field.names(this.run).map((e,t)=>[e,Mr(t)]):Array.from({length:10},(e,t)=>["",Mr(t)])}update_colours(){if(!this.scene||!this.frame||!this.mesh)return;let e=this.scene.values;Od(this.field,this.mesh,this.frame,e);let t=this.run.frames.ranges[this.field.id],n=ke("range").value==="run"&&t,s=this.field.kind==="names"?[0,1]:n?t:Bd(this.field,this.mesh,e,this.held),r=this.names();this.scene.use_colours(this.field,s,r.map(([,o])=>o)),this.legend=np(this.field,s,r.filter(([o])=>o!=="")),this.field.id==="block"&&(this.legend.what="block (neighbours differ in colour; the list below has the names)"),ip(ke("legend"),this.field,this.legend),ke("view").setAttribute("aria-label",`The blocks at ${Wn(this.frames[this.index].time)} in stage ${this.frames[this.index].stage}, coloured by ${this.field.label}`)}redraw(e=!1,t=!1){if(e&&this.own_view&&!t&&this.scene){let{x:n,y:s,scale:r}=this.scene.view;this.pair?.tell({view:[n+this.run.origin[0],s+this.run.origin[1],r]})}e&&this.shown.crosses&&this.update_layers(),!(this.draw_asked||!this.scene)&&(this.draw_asked=!0,requestAnimationFrame(()=>{this.draw_asked=!1,this.update_marks(),this.scene.render(),this.show_scale()}))}show_scale(){let e=this.scene.view.scale,t=Pd(140/e),n=Ds("m",t);this.scale_bar={pixels:t*e,text:t>=1e3?`${t/1e3} km`:`${Number((t/n.factor).toPrecision(3))} ${n.name}`},ke("scale-bar").style.width=`${this.scale_bar.pixels}px`,ke("scale-text").textContent=this.scale_bar.text}fit(e=!1){!e&&this.own_view&&this.pair?.tell({fit:!0}),this.own_view=!1,this.scene?.fit(...this.run.frames.bounds),this.redraw(!0)}zoom(e){this.own_view=!0,this.scene?.zoom(e,.5*this.scene.width,.5*this.scene.height),this.redraw(!0)}async save(){if(!this.scene)return;this.scene.render();let e=await rp(this.scene.canvas,{title:this.run.title||"Scree run",instant:this.instant(),scale:this.scale_bar,field:this.field,legend:this.legend,dark:Zm.matches,labels:this.labels}),t=Ze("a");t.href=URL.createObjectURL(e),t.download=`${this.run.folder||"scree"}-${this.field.id}-${this.frames[this.index].time.toFixed(3)}s.png`,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}choose(e){this.chosen=e,ke("block").value=String(e),this.scene?.choose(e),this.redraw(),this.show_block_facts(),ke("block-figure").hidden=e<0,e>=0&&!Qo&&this.follow_block(e)}block_mean(e,t,n,s){let r=new Float64Array(7),o=0;for(let a=0;a<s.length;++a){if(e.block[a]!==n)continue;let l=e.offsets[a],c=e.offsets[a+1],u=s[a]/(c-l);o+=s[a];for(let h=l;h<c;++h){let f=e.cells[h];for(let d of[0,1])r[d]+=u*t.displacement[2*f+d],r[2+d]+=u*t.velocity[2*f+d];for(let d of[0,1,2])r[4+d]+=u*t.stress[3*f+d]}}return o>0?Array.from(r,a=>a/o):null}show_block_facts(){let e=ke("block-facts"),t=this.run.model.blocks[this.chosen];if(!t||!this.mesh||!this.frame)return e.replaceChildren();let n=this.mesh.block.indexOf(this.chosen),s=n<0?null:this.block_mean(this.mesh,this.frame,this.chosen,this.areas(this.mesh)),r=t.rings.length>0?this.ring_area(t.rings):this.areas(this.mesh).reduce((a,l,c)=>this.mesh.block[c]===this.chosen?a+l:a,0),o=[["Material",this.run.model.materials[t.material]?.name],["Area",`${Xt(r)} m\xB2`],["Held",t.held?"yes":void 0]];if(s&&n>=0){let a=Math.hypot(.5*(s[4]-s[5]),s[6]),l=.5*(s[4]+s[5]);o.push(["Method",`${(this.run.model.methods[this.mesh.method[n]]??"").toUpperCase()}${this.frame.integrator.length===0?"":this.frame.integrator[n]===0?", explicit":", implicit"}`],["Displacement",`${mn(Math.hypot(s[0],s[1]),"m")} (${mn(s[0],"m")}, ${mn(s[1],"m")})`]),this.source.live||o.push(["Speed",mn(Math.hypot(s[2],s[3]),"m/s")],["Mean \u03C3\u2081, \u03C3\u2083",`${mn(l+a,"Pa")}, ${mn(l-a,"Pa")}`]);let c=this.frame.contacts;if(c){let u=0;for(let h=0;h<c.state.length;++h)(c.blocks[3*h]===this.chosen||c.blocks[3*h+1]===this.chosen)&&(u+=1);o.push(["Closed contacts",String(u)])}}Sa(e,o)}areas(e){let t=this.area_of.get(e);return t||this.area_of.set(e,t=Yd(e)),t}ring_area(e){return e.map(n=>{let s=0;for(let r=0;r<n.length;r+=2){let o=(r+2)%n.length;s+=n[r]*n[o+1]-n[o]*n[r+1]}return Math.abs(.5*s)}).reduce((n,s,r)=>r===0?s:n-s,0)}async follow_block(e){let t=[],n=[];for(let s=0;s<this.frames.length&&this.chosen===e;++s){let r=this.frames[s],[o,a]=await Promise.all([this.source.frame(s),this.source.mesh(r.mesh)]),l=this.block_mean(a,o,e,this.areas(a));l&&(t.push(r.time),n.push(l))}this.chosen===e&&(this.block_history={block:e,time:Float64Array.from(t),rows:n.map(s=>Float64Array.from(s))},this.draw_block())}draw_block(){let e=this.block_history;if(!e||e.block!==this.chosen)return;this.block_chart||this.charts.push(this.block_chart=this.chart("block-chart",220)),ke("block-title").textContent=`Block ${this.run.model.blocks[e.block].name}`;let t=ke("block-quantity").value,n=(a,l)=>.5*(a[4]+a[5])+l*Math.hypot(.5*(a[4]-a[5]),a[6]),s={displacement:a=>Math.hypot(a[0],a[1]),"horizontal displacement":a=>a[0],"vertical displacement":a=>a[1],speed:a=>Math.hypot(a[2],a[3]),"principal stress \u03C3\u2081":a=>n(a,1),"principal stress \u03C3\u2083":a=>n(a,-1)},r=t.includes("stress")?"Pa":t==="speed"?"m/s":"m",o=[{label:`mean ${t}`,values:e.rows.map(s[t])}];this.block_chart.draw({what:t,unit:r},e.time,o),this.block_chart.at(this.frames[this.index].time)}chart(e,t){return new ya(ke(e),t,this.run.stages,n=>this.go_to_time(n))}make_charts(){if(Qo)return;ke("monitor-figure").hidden=this.run.history.monitors.length===0,this.run.history.monitors.length>0&&(this.monitor_chart||this.charts.push(this.monitor_chart=this.chart("monitor-chart",240)),this.draw_monitors()),this.ledger_chart||this.charts.push(this.ledger_chart=this.chart("energy-chart",240)),this.draw_ledger();let e=Dd(this.rows);e.some(t=>t>0)?(this.closure_chart||this.charts.push(this.closure_chart=this.chart("closure-chart",200)),this.closure_chart.draw({what:"|closure| / moved",unit:"",log:!0},this.rows.get("l.time"),[{label:"closure",values:e}])):ke("closure-chart").textContent="Zero at every stored time.";for(let t of this.charts)t.at(this.frames[this.index].time)}draw_monitors(){let e=ke("monitor-quantity").value,{time:t,series:n,unit:s}=Ud(this.run,this.rows,e);this.monitor_chart?.draw({what:e,unit:s},t,n),this.describe("monitor-chart",`Histories of the monitors, ${e}`,n,s)}draw_ledger(){let e=ke("ledger-sides").value.split(" "),t=Ld(this.run,this.rows,e);this.ledger_chart?.draw({what:"energy",unit:"J"},this.rows.get("l.time")??[],t),this.describe("energy-chart","Energy ledger over time",t,"J")}describe(e,t,n,s){let r=n.map(o=>`${o.label} ${mn(o.values[o.values.length-1]??NaN,s)}`);ke(e).setAttribute("aria-label",`${t}. At the end: ${r.join("; ")}`)}};async function sS(){let i=document.body.dataset.source;return i===void 0?new cc:i!=="live"?fc.open():await uc.open(t=>ke("subtitle").textContent=t)}sS().then(i=>new Uu(i).start()).catch(Du);})();
